//! `delone conform`: read, validate, add Steiner points, judge, write, tell.

use delone_conforming::{ConformOptions, Limits, Method, methods};
use serde_json::Map;

use super::adding::{Adding, Own};
use crate::cli;
use crate::failure::Failure;
use crate::steiner;

pub(crate) fn conform(arguments: &cli::Conform) -> Result<(), Failure> {
    let method = method(arguments.method.name());
    let mut adding = Adding::begin(&arguments.adding, method.name)?;
    let limits = Limits { vertices_max: adding.vertices_max() };
    let cuts_max = arguments.cuts_max;
    let options = ConformOptions { limits, cuts_max, ..ConformOptions::default() };
    let conforming =
        adding.build(|subject, watch| (method.run)(steiner::graph(subject), &options, watch));
    let subject = &adding.subject;
    let pslg = adding.pslg();
    let result = steiner::Result { subject, pslg, conforming: &conforming, inside: None };
    let own = Own { schema: "delone.conform/1", keys: Map::new() };
    adding.end(&result, own, || result.verdict(&method))
}

/// The method of this name.
fn method(name: &str) -> Method {
    methods().into_iter().find(|method| method.name == name).expect("the command line has these")
}
