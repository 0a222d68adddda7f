//! The problems of the folder `problems` as a C library.

eliminant::include_solver!("own");
