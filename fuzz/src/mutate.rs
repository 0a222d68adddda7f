//! Inputs to neighbouring inputs.

use eliminant_generator::algebra::Random;

/// What an input is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Text of a language with these words.
    Text(&'static [&'static str]),
    /// Bytes, in which these words mean something.
    Bytes(&'static [&'static str]),
    /// Floating-point numbers of 8 bytes, little-endian.
    Numbers,
}

/// Numbers at which arithmetic goes wrong, as text.
const NUMBERS: [&str; 20] = [
    "0",
    "1",
    "-1",
    "2",
    "3",
    "0.5",
    "10",
    "31",
    "32",
    "33",
    "255",
    "256",
    "1000",
    "10000",
    "1e308",
    "-1e-308",
    "1e999",
    "2147483648",
    "9223372036854775807",
    "18446744073709551616",
];

/// Numbers at which arithmetic goes wrong.
const SPECIAL: [f64; 18] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    2.0,
    0.5,
    1e-8,
    1e8,
    1e-160,
    1e160,
    1e-300,
    1e300,
    f64::MAX,
    f64::MIN_POSITIVE,
    5e-324,
    f64::EPSILON,
    f64::INFINITY,
    f64::NAN,
];

/// Most mutations of one input.
const MOST: u64 = 6;

/// An input close to `parent`. Parts of `other` may be copied into it. It has at most `longest`
/// bytes.
pub fn mutate(kind: Kind, parent: &[u8], other: &[u8], longest: usize, random: &mut Random) -> Vec<u8> {
    let mut input = parent.to_vec();
    for _ in 0..=random.below(MOST) {
        match kind {
            Kind::Text(words) => mutate_text(&mut input, other, words, random),
            Kind::Bytes(words) => match random.below(3) {
                0 => mutate_text(&mut input, other, words, random),
                _ => mutate_bytes(&mut input, other, random),
            },
            Kind::Numbers => mutate_numbers(&mut input, other, random),
        }
    }
    input.truncate(longest);
    input
}

/// A random element; the default if there is none.
fn pick<T: Copy + Default>(items: &[T], random: &mut Random) -> T {
    items.get(random.below(items.len().max(1) as u64) as usize).copied().unwrap_or_default()
}

/// A random range of a length, short ones more often.
fn range(length: usize, random: &mut Random) -> std::ops::Range<usize> {
    let start = random.below(length as u64 + 1) as usize;
    let most = (length - start).min(1 << random.below(9));
    start..start + random.below(most as u64 + 1) as usize
}

/// The words, numbers and signs of a text: where each begins and ends.
fn tokens(text: &[u8]) -> Vec<std::ops::Range<usize>> {
    let is_word = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'_' || byte == b'.';
    let mut found: Vec<std::ops::Range<usize>> = Vec::new();
    for (at, &byte) in text.iter().enumerate().filter(|(_, byte)| !byte.is_ascii_whitespace()) {
        match found.last_mut() {
            Some(last) if last.end == at && is_word(byte) && is_word(text[at - 1]) => last.end = at + 1,
            _ => found.push(at..at + 1),
        }
    }
    found
}

fn mutate_text(input: &mut Vec<u8>, other: &[u8], words: &[&str], random: &mut Random) {
    let own = tokens(input);
    if own.is_empty() {
        input.extend_from_slice(pick(words, random).as_bytes());
        return;
    }
    let at = random.below(own.len() as u64) as usize;
    let token = own[at].clone();
    match random.below(12) {
        0 => drop(input.splice(token, pick(words, random).bytes())),
        1 => drop(input.splice(token.end..token.end, format!(" {} ", pick(words, random)).into_bytes())),
        2 => drop(input.splice(token, pick(&NUMBERS, random).bytes())),
        3 => {
            let numbers: Vec<_> = own.into_iter().filter(|token| input[token.start].is_ascii_digit()).collect();
            if !numbers.is_empty() {
                let number = numbers[random.below(numbers.len() as u64) as usize].clone();
                input.splice(number, pick(&NUMBERS, random).bytes());
            }
        }
        4 => drop(input.drain(token)),
        5 => {
            let copy = input[token.clone()].to_vec();
            input.splice(token.end..token.end, copy);
        }
        6 | 7 => {
            // A token in the place of another.
            let from = own[random.below(own.len() as u64) as usize].clone();
            let copy = input[from].to_vec();
            input.splice(token, copy);
        }
        8 => {
            // A run of tokens, once more or somewhere else.
            let last = own[(at + random.below(12) as usize).min(own.len() - 1)].end;
            let copy = input[token.start..last].to_vec();
            let to = own[random.below(own.len() as u64) as usize].start;
            input.splice(to..to, copy);
        }
        9 => {
            let last = own[(at + random.below(12) as usize).min(own.len() - 1)].end;
            input.drain(token.start..last);
        }
        10 => {
            let theirs = tokens(other);
            if theirs.is_empty() {
                return;
            }
            let from = random.below(theirs.len() as u64) as usize;
            let last = theirs[(from + random.below(20) as usize).min(theirs.len() - 1)].end;
            input.splice(token.start..token.start, other[theirs[from].start..last].iter().copied());
        }
        _ => mutate_bytes(input, other, random),
    }
}

fn mutate_bytes(input: &mut Vec<u8>, other: &[u8], random: &mut Random) {
    let at = random.below(input.len() as u64 + 1) as usize;
    match random.below(8) {
        0 if at < input.len() => input[at] ^= 1 << random.below(8),
        1 if at < input.len() => input[at] = random.below(256) as u8,
        2 if at < input.len() => input[at] = pick(&[0, 1, 0x7f, 0x80, 0xff, b'\n', b',', b'"'], random),
        3 => input.insert(at, random.below(256) as u8),
        4 => drop(input.drain(range(input.len(), random))),
        5 => {
            let copy = input[range(input.len(), random)].to_vec();
            input.splice(at..at, copy);
        }
        6 => drop(input.splice(at..at, other[range(other.len(), random)].iter().copied())),
        _ => {
            // A count or a number in a binary file.
            let bytes = match random.below(2) {
                0 => pick(&SPECIAL, random).to_le_bytes(),
                _ => pick(&[0, 1, 2, 1 << 31, 1 << 32, u64::MAX >> 1, u64::MAX], random).to_le_bytes(),
            };
            let end = (at + 8).min(input.len());
            input.splice(at..end, bytes);
        }
    }
}

fn mutate_numbers(input: &mut Vec<u8>, other: &[u8], random: &mut Random) {
    input.resize(input.len().max(other.len()).max(8) / 8 * 8, 0);
    let count = input.len() / 8;
    let mut values: Vec<f64> = input.chunks_exact(8).map(number).collect();
    let [at, from] = [0; 2].map(|_| random.below(count as u64) as usize);
    match random.below(12) {
        0 => values[at] = pick(&SPECIAL, random),
        1 => values[at] = f64::from_bits(random.bits()),
        2 => values[at] = random.symmetric_unit(),
        3 => values[at] = random.below(7) as f64 - 3.0,
        4 => values[at] = f64::from_bits(values[at].to_bits() ^ (1 << random.below(64))),
        5 => values[at] = values[from],
        6 => values[at] = -values[at],
        7 => values[at] *= 2f64.powi(random.below(80) as i32 - 40),
        8 => values[at] = values[from] * (1.0 + random.symmetric_unit() * 10f64.powi(-(random.below(17) as i32))),
        9 => {
            // All, or a part, in another unit.
            let factor = 2f64.powi(random.below(200) as i32 - 100);
            values[at.min(from)..=at.max(from)].iter_mut().for_each(|value| *value *= factor);
        }
        10 => values[at.min(from)..=at.max(from)].fill(pick(&[0.0, 1.0, -1.0], random)),
        _ => {
            // A part repeats another, as coincident points do.
            let length = random.below((count - at.max(from)) as u64) as usize + 1;
            values.copy_within(from..from + length, at);
        }
    }
    *input = values.iter().flat_map(|value| value.to_le_bytes()).collect();
}

/// A number of 8 bytes.
fn number(bytes: &[u8]) -> f64 {
    f64::from_le_bytes(bytes.try_into().unwrap_or_default())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tokens_are_words_numbers_and_signs() {
        let text = b"let a1 = 2.5*x;";
        let found: Vec<&[u8]> = tokens(text).into_iter().map(|token| &text[token]).collect();
        assert_eq!(found, [&b"let"[..], b"a1", b"=", b"2.5", b"*", b"x", b";"]);
    }

    #[test]
    fn the_same_seed_gives_the_same_inputs_within_the_length() {
        for kind in [Kind::Text(&["det"]), Kind::Bytes(&["x"]), Kind::Numbers] {
            let all = |seed| {
                let mut random = Random::new(seed);
                (0..500).map(|_| mutate(kind, b"fn f() -> x { x == 1; }", b"[1, 2]", 64, &mut random)).collect()
            };
            let inputs: Vec<Vec<u8>> = all(3);
            assert_eq!(inputs, all(3));
            assert_ne!(inputs, all(4));
            assert!(inputs.iter().all(|input| input.len() <= 64));
        }
    }
}
