//! What a target says of an input: which kinds of behaviour were seen.

/// What was seen while an input was run.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Outcome {
    /// Whether the input was taken: a reader read it, or a solver returned solutions.
    pub accepted: bool,
    /// Whether it took much work by its own account: no inputs are made from it, because they would
    /// take as much.
    pub expensive: bool,
    /// A hash of each kind of behaviour.
    pub kinds: Vec<u64>,
    /// What must not be; `None` if all is well.
    pub fault: Option<String>,
}

/// The offset and the factor of the hash FNV-1a.
const FNV: (u64, u64) = (0xcbf2_9ce4_8422_2325, 0x0000_0100_0000_01b3);

/// So many words of each part of a message tell its kind.
const MOST_WORDS: usize = 12;

/// A hash (FNV-1a, 64 bit) of bytes.
pub fn hash(bytes: impl IntoIterator<Item = u8>) -> u64 {
    bytes.into_iter().fold(FNV.0, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(FNV.1))
}

impl Outcome {
    /// Notes that this text was seen. What stands between the first and the last quotation mark
    /// does not count, nor do words with digits: they are the input's own.
    pub fn see(&mut self, text: &str) {
        let marks = ['`', '"', '\''];
        let (start, end) = (text.find(marks).unwrap_or(text.len()), text.rfind(marks).unwrap_or(text.len()));
        let plain = |part: &str| {
            let words = part.split_whitespace().take(MOST_WORDS);
            words.filter(|word| !word.contains(|c: char| c.is_ascii_digit())).collect::<Vec<_>>().join(" ")
        };
        self.kinds.push(hash(plain(&text[..start]).bytes().chain([0]).chain(plain(&text[end..]).bytes())));
    }

    /// Notes the order of magnitude of a count.
    pub fn count(&mut self, what: &str, count: usize) {
        let size = usize::BITS - count.leading_zeros();
        self.kinds.push(hash(what.bytes().chain([size as u8])));
    }

    /// Notes a fault, unless `good`.
    pub fn demand(&mut self, good: bool, fault: impl FnOnce() -> String) {
        if !good && self.fault.is_none() {
            self.fault = Some(fault());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_numbers_of_the_input_make_no_kind() {
        let kind = |text: &str| {
            let mut outcome = Outcome::default();
            outcome.see(text);
            outcome.kinds
        };
        assert_eq!(kind("`x` has 3 rows"), kind("`long` has 17 rows"));
        assert_ne!(kind("`x` has 3 rows"), kind("`x` has 3 columns"));
    }
}
