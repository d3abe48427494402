//! Models move between threads; a token stops them from any thread and may outlive them.

use std::ops::ControlFlow;
use std::sync::mpsc;
use std::thread;

use crate::common::{block, plate};
use bempd::{CancelToken, Model, State, StopReason};

fn movable<T: Send>() {}
fn shareable<T: Send + Sync>() {}

#[test]
fn models_and_states_are_movable_and_tokens_shareable() {
    movable::<Model>();
    movable::<State>();
    shareable::<CancelToken>();
    shareable::<bempd::Error>();
}

#[test]
fn a_model_works_in_another_thread() {
    let mut here = plate();
    let mut there = plate();
    here.model.run_to_separation(1000.0).unwrap();
    let there = thread::spawn(move || {
        there.model.run_to_separation(1000.0).unwrap();
        there
    });
    assert_eq!(there.join().unwrap().outcome(), here.outcome());
}

#[test]
fn an_error_reaches_the_thread_that_made_the_call() {
    let mut model = Model::new().unwrap();
    let error = thread::spawn(move || model.prepare().unwrap_err()).join().unwrap();
    assert!(error.sentence().starts_with("bempd_prepare: "));
}

#[test]
fn a_token_stops_a_step_from_another_thread() {
    let mut plate = plate();
    plate.model.step(0.01).unwrap();
    let before = plate.outcome();
    let token = plate.model.cancel_token();
    let (at_work, told) = mpsc::channel();
    let (cancelled, go_on) = mpsc::channel();
    // The first event waits for the request, so that it falls into the step for certain.
    plate
        .model
        .set_progress(move |_| {
            at_work.send(()).unwrap();
            go_on.recv().unwrap();
            ControlFlow::Continue(())
        })
        .unwrap();
    let other = thread::spawn(move || {
        told.recv().unwrap();
        token.cancel();
        cancelled.send(()).unwrap();
    });
    assert_fails!(plate.model.run_to_separation(1000.0), Cancelled, "on request");
    other.join().unwrap();
    assert_eq!(plate.outcome(), before);
}

#[test]
fn a_stopped_step_keeps_its_events() {
    let mut plate = plate();
    let token = plate.model.cancel_token();
    plate
        .model
        .set_progress(move |now| {
            if now.events == 2 {
                token.stop();
            }
            ControlFlow::Continue(())
        })
        .unwrap();
    let report = plate.model.run_to_separation(1000.0).unwrap();
    assert_eq!((report.stop_reason, report.events), (StopReason::Requested, 2));
    plate.model.clear_progress().unwrap();
    assert!(plate.model.run_to_separation(1000.0).unwrap().separated);
}

#[test]
fn long_parts_say_how_far_they_are_and_can_cancel() {
    let mut plate = plate();
    let (tell, told) = mpsc::channel();
    plate
        .model
        .set_phase_progress(move |now| {
            tell.send((now.phase.to_owned(), now.share)).unwrap();
            ControlFlow::Break(())
        })
        .unwrap();
    assert_fails!(plate.model.step(0.01), Cancelled, "the phase callback asked to stop");
    let (phase, share) = told.recv().unwrap();
    assert!(!phase.is_empty() && (0.0..=1.0).contains(&share));
    plate.model.clear_phase_progress().unwrap();
    plate.model.step(0.01).unwrap();
}

#[test]
fn a_request_while_no_step_runs_is_forgotten() {
    let mut plate = plate();
    plate.model.cancel_token().cancel();
    plate.model.step(0.1).unwrap();
}

#[test]
fn a_token_outlives_its_model() {
    let model = block().model;
    let token = model.cancel_token();
    drop(model);
    token.cancel();
}

#[test]
fn requests_and_the_end_of_the_model_may_meet() {
    for _ in 0..200 {
        let model = Model::new().unwrap();
        let token = model.cancel_token();
        let other = thread::spawn(move || (0..100).for_each(|_| token.cancel()));
        drop(model);
        other.join().unwrap();
    }
}
