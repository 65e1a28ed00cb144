use delone_laws::fuzz::{Shard, Tally, target};

use super::{Timed, load, load_all, path, save};

#[test]
fn a_tally_is_read_as_it_was_written() {
    let (folder, canary) = (tempfile::tempdir().unwrap(), target("canary").unwrap());
    let shard = Shard::of(1, 3).unwrap();
    let mut tally = Tally::new(&canary, 5, shard);
    (0..100).for_each(|_| tally.step(&canary));
    assert!(!tally.findings.is_empty());
    let timed = Timed { tally, seconds: 0.25 };
    save(folder.path(), &timed).unwrap();
    let file = path(folder.path(), "canary", 5, shard);
    assert_eq!(load(&file).unwrap(), timed);
    assert_eq!(load_all(folder.path()).unwrap(), vec![vec![timed]]);
}

#[test]
fn what_is_no_shard_is_refused_by_name() {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in [("a.json", "{}"), ("b.json", "not json"), ("c.json", "[1, 2]")] {
        let file = folder.path().join(name);
        std::fs::write(&file, text).unwrap();
        assert!(load(&file).unwrap_err().to_string().contains(name));
    }
}
