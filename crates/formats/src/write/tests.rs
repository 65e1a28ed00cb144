use super::*;

#[test]
fn numbers_are_short_and_exact() {
    let cases = [
        (1.0, "1"),
        (-0.0, "-0"),
        (0.1, "0.1"),
        (1e300, "1e300"),
        (5e-324, "5e-324"),
        (123456.5, "123456.5"),
    ];
    for (x, text) in cases {
        assert_eq!(shortest(x), text);
    }
}

#[test]
fn what_is_lost_is_said() {
    let document = Document {
        segments: vec![[0, 1]],
        points: vec![0.0; 4],
        holes: vec![1.0; 2],
        ..Document::new(2)
    };
    let lost = write(&document, Format::Xyz, &mut Vec::new()).unwrap();
    assert_eq!(lost, ["1 segments not written", "1 holes not written"]);
    assert!(matches!(
        write(&document, Format::Ply, &mut Vec::new()),
        Err(WriteError::ReadOnly(Format::Ply))
    ));
    let nan = Document { points: vec![0.0, f64::NAN], ..Document::new(2) };
    assert!(matches!(
        write(&nan, Format::Lar, &mut Vec::new()),
        Err(WriteError::NotFinite { point: 0 })
    ));
}

#[test]
fn files_are_whole_or_absent() {
    let folder = std::env::temp_dir().join(format!("delone-formats-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let path = folder.join("a.txt");
    let failed: io::Result<()> = write_atomically(&path, |out| {
        out.write_all(b"half")?;
        Err(io::Error::other("no"))
    });
    assert!(failed.is_err());
    assert_eq!(fs::read_dir(&folder).unwrap().count(), 0);
    write_atomically(&path, |out| out.write_all(b"whole")).unwrap();
    assert_eq!(fs::read(&path).unwrap(), b"whole");
    fs::remove_dir_all(&folder).unwrap();
}
