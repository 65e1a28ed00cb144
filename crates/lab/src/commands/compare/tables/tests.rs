use super::escaped;

#[test]
fn what_latex_takes_for_orders_is_escaped() {
    assert_eq!(escaped("a_b & 50 %"), "a\\_b \\& 50 \\%");
    assert_eq!(escaped("\\x^2~"), "\\textbackslash{}x\\textasciicircum{}2\\textasciitilde{}");
}
