#[path = "../examples/make_scene/random.rs"]
mod random;
#[path = "../examples/make_scene/scene.rs"]
#[allow(dead_code)]
mod scene;
mod scenes;
use eliminant_cylinders::*;
use nalgebra::{Point2, Point3, Vector2};
use random::Random;
use scene::{Can, Photograph, Setup};
type Segment = [Point2<f64>; 2];
fn segment(can: &Can, setup: &Setup, photograph: &Photograph, side: f64, part: [f64; 2]) -> Segment {
    let rotation = photograph.camera.fixed_columns::<3>(0);
    let centre = Point3::from(-(rotation.tr_mul(&photograph.camera.column(3))));
    let direction = can.direction.into_inner();
    let offset = centre - can.base;
    let perpendicular = offset - direction * direction.dot(&offset);
    let (toward, cosine) = (perpendicular.normalize(), can.radius / perpendicular.norm());
    let sideways = direction.cross(&toward) * (side * (1.0 - cosine * cosine).sqrt());
    let bottom = can.base + (toward * cosine + sideways) * can.radius;
    part.map(|part| {
        let image = setup.calibration * photograph.camera * (bottom + direction * (can.height * part)).to_homogeneous();
        Point2::new(image.x / image.z, image.y / image.z)
    })
}
fn moved(segment: Segment, noise: f64, random: &mut Random) -> Segment {
    segment.map(|end| end + Vector2::new(random.normal(), random.normal()) * noise)
}
/// distinct lines n, each `copies` times at scatter; random scenes.
fn build(
    seed: u64,
    distinct: usize,
    copies: usize,
    noise: f64,
    scatter: f64,
    piece: bool,
    soda: bool,
) -> (Can, Vec<View>) {
    let mut random = Random::new(seed);
    let (can, setup) =
        if soda { (scene::soda_can(), scene::soda_can_setup()) } else { scenes::random_scene(&mut random, 0.0) };
    let photographs = scene::photographs(&can, &setup, &mut random);
    let mut places: Vec<(usize, f64)> = (0..photographs.len()).flat_map(|i| [(i, 1.0), (i, -1.0)]).collect();
    for last in (1..places.len()).rev() {
        let o = random.uniform(0.0, (last + 1) as f64) as usize;
        places.swap(last, o.min(last));
    }
    places.truncate(distinct);
    let mut views = Vec::new();
    for (index, photograph) in photographs.iter().enumerate() {
        let mut segs = Vec::new();
        for (_, side) in places.iter().filter(|p| p.0 == index) {
            let base = moved(segment(&can, &setup, photograph, *side, [0.0, 1.0]), noise, &mut random);
            for c in 0..copies {
                let at = |p: f64| base[0] + (base[1] - base[0]) * p;
                let s = if piece {
                    let w = 1.0 / copies as f64;
                    let a = w * c as f64;
                    [at(a + 0.1 * w * random.uniform(0.0, 1.0)), at(a + w - 0.6 * w * random.uniform(0.0, 1.0))]
                } else {
                    base
                };
                segs.push(moved(s, scatter, &mut random));
            }
        }
        let camera = *scenes::view(&setup, &photograph.camera, &[]).camera();
        views.push(View::from_pixel_segments(camera, &segs).expect("segments"));
    }
    (can, views)
}
#[test]
fn explore() {
    for soda in [true, false] {
        for (distinct, copies, noise, scatter, piece) in [
            (3, 2, 0.5, 2.0, false),
            (3, 3, 0.5, 1.0, false),
            (3, 4, 0.0, 1.0, true),
            (3, 5, 0.0, 2.0, true),
            (4, 1, 0.5, 0.0, false),
            (4, 3, 0.5, 1.0, true),
            (8, 1, 3.0, 0.0, false),
        ] {
            for name in ["plain", "refine", "robust"] {
                let (mut err, mut warned, mut silent, mut wrong, mut wrong5, mut listed) = (0, 0, 0, 0, 0, 0);
                for seed in 0..400 {
                    let (can, views) = build(seed, distinct, copies, noise, scatter, piece, soda);
                    let method = match name {
                        "plain" => Method::LeastSquares,
                        "refine" => Method::Refined,
                        _ => Method::Robust(RobustOptions::of(&views)),
                    };
                    match estimate(&views, &method) {
                        Err(_) => err += 1,
                        Ok(e) if !e.warnings.is_empty() => {
                            warned += 1;
                            let pl = e.plausible.as_ref().unwrap();
                            listed += usize::from(
                                pl.cylinders.iter().any(|c| (c.cylinder.radius / can.radius - 1.0).abs() < 0.1),
                            );
                        }
                        Ok(e) => {
                            silent += 1;
                            let off = (e.cylinder.radius / can.radius - 1.0).abs();
                            if off > 0.05 {
                                wrong += 1;
                                let dev = e.refinement.as_ref().map_or(0.0, |r| r.0.deviation.radius);
                                if dev == 0.0 || (e.cylinder.radius - can.radius).abs() > 5.0 * dev {
                                    wrong5 += 1;
                                }
                            }
                        }
                    }
                }
                println!(
                    "soda {soda} {distinct}x{copies} noise {noise} scatter {scatter} piece {piece} {name}: err {err} warned {warned} (truth listed {listed}) silent {silent} wrong>5% {wrong}, >5 dev {wrong5}"
                );
            }
        }
    }
}
#[test]
fn look() {
    for seed in 0..60 {
        let (can, views) = build(seed, 8, 1, 3.0, 0.0, false, true);
        let e = estimate(&views, &Method::Robust(RobustOptions::of(&views))).unwrap();
        if !e.warnings.is_empty() {
            let c = e.consensus.as_ref().unwrap();
            println!(
                "seed {seed} radius {} of {} in {} thr {} nfa {} warnings {:?} noise {}",
                e.cylinder.radius,
                can.radius,
                c.independent,
                c.threshold,
                c.false_alarms,
                e.warnings,
                e.refinement.as_ref().unwrap().0.noise
            );
            for a in &e.plausible.as_ref().unwrap().cylinders {
                println!("    {} {} {}", a.cylinder.radius, a.rms, a.plausibility);
            }
        }
    }
}
#[test]
fn coverage() {
    for (ends, kind) in [(true, 2), (false, 0), (false, 1), (false, 2), (false, 3)] {
        for (cameras, share) in [(15usize, 0.0), (15, 0.5), (15, 0.7), (6, 0.0), (6, 0.5)] {
            for noise in [0.5, 3.0] {
                let (mut one, mut two, mut n, mut err, mut missed, mut extra, mut warned) = (0, 0, 0, 0, 0, 0, 0);
                let mut errors = 0.0;
                let mut maha = 0;
                for seed in 0..500 {
                    let mut random = Random::new(seed);
                    let (can, setup) = (scene::soda_can(), Setup { cameras, noise: 0.0, ..scene::soda_can_setup() });
                    let photographs = scene::photographs(&can, &setup, &mut random);
                    let outliers = (2.0 * cameras as f64 * share / (1.0 - share)).round() as usize;
                    let mut views = Vec::new();
                    for (index, photograph) in photographs.iter().enumerate() {
                        let mut segs: Vec<Segment> = [1.0, -1.0]
                            .iter()
                            .map(|&side| {
                                let part = match kind {
                                    0 => [0.0, 1.0],
                                    1 => [0.3, 0.5],
                                    2 => {
                                        let l = random.uniform(0.1, 0.5);
                                        let a = random.uniform(0.0, 1.0 - l);
                                        [a, a + l]
                                    }
                                    _ => [-2.0, 3.0],
                                };
                                moved(segment(&can, &setup, photograph, side, part), noise, &mut random)
                            })
                            .collect();
                        let count = outliers * (index + 1) / cameras - outliers * index / cameras;
                        for _ in 0..count {
                            segs.push(
                                [0, 1].map(|_| Point2::new(random.uniform(0.0, 4000.0), random.uniform(0.0, 3000.0))),
                            );
                        }
                        let camera = *scenes::view(&setup, &photograph.camera, &[]).camera();
                        let view = View::from_pixel_segments(camera, &segs).expect("segments");
                        let count = segs.len();
                        views.push(if ends { view } else { view.with_ends(vec![None; count]).unwrap() });
                    }
                    let method = Method::Robust(RobustOptions::of(&views));
                    match estimate(&views, &method) {
                        Err(_) => err += 1,
                        Ok(e) => {
                            n += 1;
                            warned += usize::from(!e.warnings.is_empty());
                            let r = &e.refinement.as_ref().unwrap().0;
                            let z = (r.cylinder.radius - can.radius).abs() / r.deviation.radius;
                            errors += (r.cylinder.radius - can.radius).powi(2);
                            one += usize::from(z < 1.0);
                            two += usize::from(z < 1.96);
                            let truth = scenes::truth(&can);
                            let [f1, f2] = r.across;
                            let w = truth.direction.into_inner() * truth.direction.dot(&r.cylinder.direction).signum();
                            let dw = w - r.cylinder.direction.into_inner();
                            let at = truth.axis_at(truth.height(&r.reference));
                            let da = at - r.reference;
                            let d = nalgebra::SVector::<f64, 5>::from([
                                f1.dot(&dw),
                                f2.dot(&dw),
                                f1.dot(&da),
                                f2.dot(&da),
                                can.radius - r.cylinder.radius,
                            ]);
                            let m = d.dot(&r.covariance.cholesky().unwrap().solve(&d));
                            maha += usize::from(m < 11.07);
                            let ins = &e.consensus.as_ref().unwrap().inliers;
                            missed += (0..cameras)
                                .flat_map(|v| [(v, 0), (v, 1)])
                                .filter(|p| !ins.iter().any(|i| (i.view, i.line) == *p))
                                .count();
                            extra += ins.iter().filter(|i| i.line > 1).count();
                        }
                    }
                }
                println!(
                    "cover ends {ends} kind {kind} cameras {cameras} outliers {share} noise {noise}: err {err} warned {warned} 1s {:.1} 95 {:.1} all5 {:.1} rms {:.4} missed {missed} of {} extra {extra}",
                    100.0 * one as f64 / n as f64,
                    100.0 * two as f64 / n as f64,
                    100.0 * maha as f64 / n as f64,
                    (errors / n as f64).sqrt(),
                    2 * cameras * n
                );
            }
        }
    }
}
