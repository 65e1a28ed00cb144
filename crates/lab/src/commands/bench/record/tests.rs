use super::{Record, csv, read};

#[test]
fn a_record_is_read_as_it_was_written() {
    let record = |engine: &str, time, verdict: &str| Record {
        definition: "d".into(),
        input: "uniform".into(),
        sites: 10,
        segments: 3,
        engine: engine.into(),
        version: "1.0, \"beta\"".into(),
        round: 2,
        time,
        verdict: verdict.into(),
        fingerprint: "00ff".into(),
        counts: "orients=3 flips=4".into(),
    };
    let all = [record("ours, 2 threads", Some(0.1), "ok"), record("x", None, "WRONG: a\nb, c")];
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("r.csv");
    std::fs::write(&path, csv(&all)).unwrap();
    let again = read(&path).unwrap();
    assert_eq!(again[0], all[0]);
    assert_eq!((again[1].time, again[1].verdict.as_str()), (None, "WRONG: a b, c"));
    std::fs::write(&path, "a,b\n1,2\n").unwrap();
    assert!(read(&path).is_err());
}
