//! The committed inputs, and how new ones are chosen and shortened.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::{fs, io};

use crate::campaign::run;
use crate::outcome::hash;
use crate::target::Target;

/// The folder of the inputs of a target.
pub fn folder(target: &Target) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("corpora").join(target.name)
}

/// The inputs in a folder, in the order of their names.
///
/// # Errors
/// The folder or a file cannot be read.
pub fn read(folder: &Path) -> io::Result<Vec<Vec<u8>>> {
    let mut paths: Vec<PathBuf> = fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect::<io::Result<_>>()?;
    paths.sort();
    paths.iter().filter(|path| path.is_file()).map(fs::read).collect()
}

/// Writes inputs in the place of those in the folder of a target, each named by a hash.
///
/// # Errors
/// A file cannot be removed or written.
pub fn replace(target: &Target, inputs: &[Vec<u8>]) -> io::Result<()> {
    let folder = folder(target);
    if folder.exists() {
        fs::remove_dir_all(&folder)?;
    }
    fs::create_dir_all(&folder)?;
    for input in inputs {
        fs::write(folder.join(format!("{:016x}", hash(input.iter().copied()))), input)?;
    }
    Ok(())
}

/// At most `most` of the inputs that show as many kinds of behaviour as possible, shortened. One
/// that shows more that is new goes before one that shows less, a short one before a long one.
pub fn reduce(target: &Target, pool: &[Vec<u8>], most: usize) -> Vec<Vec<u8>> {
    let kinds_of = |input: &[u8]| -> BTreeSet<u64> { run(target, input).kinds.into_iter().collect() };
    let mut left: Vec<(BTreeSet<u64>, &Vec<u8>)> = pool.iter().map(|input| (kinds_of(input), input)).collect();
    left.sort_by_key(|(_, input)| input.len());
    let mut chosen = Vec::new();
    while chosen.len() < most {
        let Some((at, _)) = left.iter().enumerate().rev().max_by_key(|(_, (kinds, _))| kinds.len()) else { break };
        let (new, input) = left.swap_remove(at);
        if new.is_empty() {
            break;
        }
        left.iter_mut().for_each(|(kinds, _)| kinds.retain(|kind| !new.contains(kind)));
        chosen.push(shorten(input, |shorter| kinds_of(shorter).is_superset(&new)));
        left.sort_by_key(|(_, input)| input.len());
    }
    chosen
}

/// Removes parts, halves first, then smaller ones, while the input stays good.
fn shorten(input: &[u8], is_good: impl Fn(&[u8]) -> bool) -> Vec<u8> {
    let mut input = input.to_vec();
    let mut part = input.len() / 2;
    while part > 0 {
        let mut at = 0;
        while at < input.len() {
            let shorter = [&input[..at], &input[(at + part).min(input.len())..]].concat();
            if is_good(&shorter) {
                input = shorter;
            } else {
                at += part;
            }
        }
        part /= 2;
    }
    input
}

#[cfg(test)]
mod tests {
    use super::shorten;

    #[test]
    fn only_what_matters_is_left() {
        let is_good = |input: &[u8]| input.contains(&b'a') && input.contains(&b'z');
        assert_eq!(shorten(b"some words, then z, then a, and more", is_good), b"za");
    }
}
