//! Elimination, eigenvalues, eigenvectors and real roots beside nalgebra, interleaved in one run,
//! so that a drifting clock hits all alike; medians over rounds. `cargo bench -p eliminant`.

use eliminant::emitted::{Fixed, Hessenberg, real_roots, solve_block, solve_block_trailing};
use nalgebra::SMatrix;
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::{Rng, SeedableRng};
use std::hint::black_box;
use std::rc::Rc;
use std::time::Instant;

const INSTANCES: usize = 64;
const ROUNDS: usize = 401;

/// Something that is timed on one instance after the other.
struct Contender {
    name: String,
    run: Box<dyn FnMut(usize)>,
    nanoseconds: Vec<f64>,
}

impl Contender {
    fn new(name: impl Into<String>, run: impl FnMut(usize) + 'static) -> Self {
        Contender { name: name.into(), run: Box::new(run), nanoseconds: Vec::new() }
    }
}

fn matrices<const R: usize, const C: usize>(seed: u64) -> [[[f64; C]; R]; INSTANCES] {
    let mut random = Xoshiro256PlusPlus::seed_from_u64(seed);
    std::array::from_fn(|_| {
        std::array::from_fn(|_| std::array::from_fn(|_| (random.next_u64() >> 11) as f64 * 2.0_f64.powi(-52) - 1.0))
    })
}

/// N x N with M right-hand sides. A macro: nalgebra's static LU cannot be called with generic
/// sizes.
macro_rules! elimination {
    ($contenders:ident, $n:literal, $m:literal) => {
        let (a, b) = (matrices::<$n, $n>(1), matrices::<$n, $m>(2));
        $contenders.push(Contender::new(format!("LU {} x {}, {} right-hand sides", $n, $n, $m), move |k| {
            let (mut lu, mut x) = (black_box(a[k]), b[k]);
            let _ = black_box(solve_block(&mut lu, &mut x));
            black_box(x);
        }));
        $contenders.push(Contender::new(format!("    only the last {} rows", $m), move |k| {
            let (mut lu, mut x) = (black_box(a[k]), b[k]);
            let _ = black_box(solve_block_trailing(&mut lu, &mut x, $m));
            black_box(x);
        }));
        let na = a.map(|rows| SMatrix::<f64, $n, $n>::from_fn(|i, j| rows[i][j]));
        let nb = b.map(|rows| SMatrix::<f64, $n, $m>::from_fn(|i, j| rows[i][j]));
        $contenders.push(Contender::new("    nalgebra", move |k| {
            let mut x = nb[k];
            black_box(black_box(na[k]).lu().solve_mut(&mut x));
            black_box(x);
        }));
    };
}

macro_rules! spectrum {
    ($contenders:ident, $n:literal) => {
        let a = matrices::<$n, $n>(3);
        $contenders.push(Contender::new(format!("Hessenberg {} x {}", $n, $n), move |k| {
            let _ = black_box(Hessenberg::reduce(black_box(&a[k])));
        }));
        $contenders.push(Contender::new(format!("eigenvalues {} x {}", $n, $n), move |k| {
            let _ = black_box(Hessenberg::reduce(black_box(&a[k])).and_then(|h| h.eigenvalues()));
        }));
        $contenders.push(Contender::new(format!("real roots of degree {}", $n - 1), move |k| {
            black_box(real_roots(Fixed::<$n>, black_box(&a[k][0])).roots);
        }));
        let na = a.map(|rows| SMatrix::<f64, $n, $n>::from_fn(|i, j| rows[i][j]));
        $contenders.push(Contender::new("    nalgebra", move |k| {
            let schur = nalgebra::Schur::try_new(black_box(na[k]), f64::EPSILON, 1000);
            black_box(schur.map(|schur| schur.complex_eigenvalues()));
        }));
        let spectra = a.map(|rows| {
            let h = Hessenberg::reduce(&rows).unwrap();
            let values = h.eigenvalues().unwrap();
            (h, values)
        });
        let spectra = Rc::new(spectra);
        $contenders.push(Contender::new("    one real eigenvector", {
            let spectra = Rc::clone(&spectra);
            move |k| {
                let (h, values) = &spectra[k];
                black_box(h.eigenvector(black_box(values[0].re)));
            }
        }));
        $contenders.push(Contender::new("    one complex eigenvector", move |k| {
            let (h, values) = &spectra[k];
            black_box(h.eigenvector(black_box(values[0])));
        }));
    };
}

fn main() {
    let mut contenders = Vec::new();
    elimination!(contenders, 6, 4);
    elimination!(contenders, 10, 10);
    elimination!(contenders, 25, 9);
    elimination!(contenders, 40, 20);
    spectrum!(contenders, 4);
    spectrum!(contenders, 9);
    spectrum!(contenders, 15);
    for _ in 0..ROUNDS {
        for contender in &mut contenders {
            let start = Instant::now();
            for k in 0..INSTANCES {
                (contender.run)(k);
            }
            contender.nanoseconds.push(start.elapsed().as_secs_f64() * 1e9 / INSTANCES as f64);
        }
    }
    for contender in &mut contenders {
        contender.nanoseconds.sort_by(f64::total_cmp);
        println!("{:50} {:8.0} ns", contender.name, contender.nanoseconds[ROUNDS / 2]);
    }
}
