//! Closures: they are told, they cancel, and their panics reach the caller with the model as it was.

use std::cell::RefCell;
use std::ops::ControlFlow;
use std::panic::{catch_unwind, AssertUnwindSafe};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};

use crate::common::{block, plate, Block};
use bempd::{BoundaryValue, Component, LogLevel, Model};

/// The message of the panic that `body` ends with.
fn panic_of<T>(body: impl FnOnce() -> T) -> String {
    let panic = match catch_unwind(AssertUnwindSafe(body)) {
        Ok(_) => panic!("no panic came through"),
        Err(panic) => panic,
    };
    panic.downcast_ref::<&str>().map(|message| message.to_string()).expect("the payload of the closure")
}

#[test]
fn progress_is_told_after_every_event() {
    let mut plate = plate();
    let seen = Arc::new(Mutex::new(Vec::new()));
    let told = Arc::clone(&seen);
    plate
        .model
        .set_progress(move |now| {
            told.lock().unwrap().push(now);
            ControlFlow::Continue(())
        })
        .unwrap();
    let report = plate.model.run_to_separation(1000.0).unwrap();
    let seen = seen.lock().unwrap();
    assert!(report.events > 1);
    assert_eq!(seen.len() as i64, report.events);
    assert_eq!(seen.last().unwrap().broken_bonds, report.broken_bonds);
}

#[test]
fn a_step_that_progress_breaks_off_returns_to_its_start() {
    let mut plate = plate();
    plate.model.step(0.01).unwrap();
    let before = plate.outcome();
    plate.model.set_progress(|_| ControlFlow::Break(())).unwrap();
    assert_fails!(plate.model.run_to_separation(1000.0), Cancelled, "progress");
    assert_eq!(plate.outcome(), before);
    plate.model.clear_progress().unwrap();
    assert!(plate.model.run_to_separation(1000.0).unwrap().events > 1);
}

#[test]
fn a_panic_in_progress_reaches_the_caller_and_the_model_goes_on() {
    let mut plate = plate();
    plate.model.step(0.01).unwrap();
    let before = plate.outcome();
    plate.model.set_progress(|now| if now.events < 2 { ControlFlow::Continue(()) } else { panic!("no more") }).unwrap();
    assert_eq!(panic_of(|| plate.model.run_to_separation(1000.0)), "no more");
    assert_eq!(plate.outcome(), before);
    plate.model.clear_progress().unwrap();
    assert!(plate.model.run_to_separation(1000.0).unwrap().events > 1);
}

#[test]
fn a_panic_in_the_log_cancels_the_step_and_is_the_only_one() {
    let mut plate = plate();
    let calls = Arc::new(AtomicUsize::new(0));
    let counted = Arc::clone(&calls);
    plate
        .model
        .set_log(move |_, _| {
            counted.fetch_add(1, Ordering::Relaxed);
            panic!("unreadable")
        })
        .unwrap();
    // Preparing logs first, so the step ends at its first event.
    assert_eq!(panic_of(|| plate.model.run_to_separation(1000.0)), "unreadable");
    assert_eq!(calls.load(Ordering::Relaxed), 1);
    plate.model.clear_log().unwrap();
    assert_eq!(plate.model.history_count().unwrap(), 0);
    assert!(plate.model.run_to_separation(1000.0).unwrap().events > 1);
}

#[test]
fn the_log_has_lines() {
    let mut plate = plate();
    let lines = Arc::new(Mutex::new(Vec::new()));
    let written = Arc::clone(&lines);
    plate.model.set_log(move |level, line| written.lock().unwrap().push((level, line.to_owned()))).unwrap();
    plate.model.prepare().unwrap();
    let lines = lines.lock().unwrap();
    assert!(lines.iter().any(|(level, line)| *level == LogLevel::Information && line.starts_with("prepared: ")));
}

fn pulled(x: f64, y: f64) -> Option<BoundaryValue> {
    assert!((x - 10.0).abs() < 1e-9 && (-1e-9..8.0 + 1e-9).contains(&y), "({x}, {y})");
    Some(BoundaryValue { constant: [3.0, 0.0], proportional: [5.0, 0.0] })
}

#[test]
fn boundary_functions_give_tractions_and_displacements() {
    let Block { mut model, region, support } = block();
    model.add_traction_function(region, 2, .., pulled).unwrap();
    model.step(2.0).unwrap();
    let [x, _] = model.reaction(support).unwrap();
    assert!((x + 13.0 * 8.0).abs() < 1e-6, "{x}");

    let Block { mut model, region, .. } = block();
    model.prescribe_edge_function(region, 2, .., Component::Both, pulled).unwrap();
    model.step(2.0).unwrap();
    let [x, y] = model.evaluate_displacement(&[[10.0, 4.0]]).unwrap()[0];
    assert!((x - 13.0).abs() < 1e-9 && y.abs() < 1e-9, "{x}, {y}");
}

#[test]
fn boundary_functions_are_kept_until_the_model_is_prepared() {
    let Block { mut model, region, .. } = block();
    let owned = Arc::new(());
    let kept = Arc::clone(&owned);
    let function = move |x, y| {
        let _ = &kept;
        pulled(x, y)
    };
    model.add_traction_function(region, 2, .., function).unwrap();
    assert_eq!(Arc::strong_count(&owned), 2);
    model.step(1.0).unwrap();
    drop(model);
    assert_eq!(Arc::strong_count(&owned), 1);
}

#[test]
fn boundary_functions_cancel_with_none_and_panic_through() {
    let Block { mut model, region, .. } = block();
    let added = model.add_traction_function(region, 2, .., |_, _| None);
    assert_fails!(added.and_then(|_| model.prepare()), Cancelled, "boundary function");

    // A callback may ask also where its call has only a shared borrow of the model.
    let Block { mut model, region, .. } = block();
    let message = panic_of(|| {
        model.add_traction_function(region, 2, .., |_, _| panic!("no value here")).unwrap();
        model.node_count(region)
    });
    assert_eq!(message, "no value here");
}

#[test]
fn boundary_functions_give_finite_values() {
    let Block { mut model, region, .. } = block();
    let not_a_number = |_, _| Some(BoundaryValue { constant: [f64::NAN, 0.0], ..Default::default() });
    let added = model.add_traction_function(region, 2, .., not_a_number);
    assert_fails!(added.and_then(|_| model.prepare()), Argument, "finite");
}

thread_local! {
    static SHARED: RefCell<Option<Model>> = RefCell::new(None);
}

/// The one way back into a model that is at work: shared borrows of a cell. The library refuses it.
#[test]
fn a_closure_cannot_use_the_model_that_calls_it() {
    let Block { mut model, region, .. } = block();
    let inner = Arc::new(Mutex::new(None));
    let seen = Arc::clone(&inner);
    model
        .set_log(move |_, _| {
            let result = SHARED.with(|shared| shared.borrow().as_ref().map(|model| model.load_factor()));
            *seen.lock().unwrap() = result;
        })
        .unwrap();
    SHARED.with(|shared| {
        *shared.borrow_mut() = Some(model);
        let nodes = shared.borrow().as_ref().unwrap().node_count(region).unwrap();
        assert!(nodes > 0);
        shared.borrow_mut().take();
    });
    let refused = inner.lock().unwrap().take().expect("a line of the log");
    assert_fails!(refused, Order, "callback");
}

#[test]
fn a_replaced_closure_is_dropped() {
    let Block { mut model, .. } = block();
    let owned = Arc::new(());
    let kept = Arc::clone(&owned);
    model.set_log(move |_, _| drop(Arc::clone(&kept))).unwrap();
    assert_eq!(Arc::strong_count(&owned), 2);
    model.set_log(|_, _| ()).unwrap();
    assert_eq!(Arc::strong_count(&owned), 1);
}
