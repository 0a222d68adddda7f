//! Emitted code states the version of the interface that it was written for.

use std::panic::catch_unwind;

use eliminant::emitted::{VERSION, check_version};

// As emitted.
const _: () = check_version(VERSION);

#[test]
fn another_version_is_refused_with_a_hint() {
    check_version(VERSION);
    for other in [VERSION - 1, VERSION + 1, u32::MAX] {
        let panic = catch_unwind(|| check_version(other)).unwrap_err();
        let message = panic.downcast_ref::<&str>().expect("a message");
        assert!(message.contains("use equal versions of both crates and build again"), "{message}");
    }
}
