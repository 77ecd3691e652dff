use crate::geo::Point2;
use crate::ir::undercut::Surface;
use crate::machine::Undercuts;
use crate::parser::sinumerik::records::{Record, read};

use super::compare::{Difference, compare};
use super::generate::solve;
use super::made::*;

const DIAMETERS: Written = Written { diameter: true, unit: 1.0 };

fn records(text: &str) -> Vec<Record> {
    let lines = text.lines().map(|line| format!("{};*GP*;*RO*;*HD*", line.trim()));
    lines.map(|line| read(line.as_bytes()).expect("a record")).collect()
}

fn number(v: f64) -> String {
    let text = format!("{v:.3}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// The NC half in short: all words of every block, ordinates as written.
fn words(text: &str, scale: f64) -> Vec<String> {
    let made =
        solve(&records(text), Written { diameter: scale == 2.0, unit: 1.0 }, &Undercuts::default()).expect("a contour");
    let point = |p: Point2| format!("{} {}", number(p.x), number(p.y * scale));
    let mut list = vec![format!("G0 {}", point(made.start))];
    for block in &made.blocks {
        let mut line = match block.arc {
            None => format!("G1 {}", point(block.end)),
            Some((center, ccw)) => {
                format!("{} {} AC {}", if ccw { "G3" } else { "G2" }, point(block.end), point(center))
            }
        };
        match block.corner {
            Some(CornerWord::Radius(r)) => line += &format!(" RND{}", number(r)),
            Some(CornerWord::Chamfer(c)) => line += &format!(" CHR{}", number(c)),
            Some(CornerWord::Undercut(_)) | None => {}
        }
        list.push(line);
    }
    list
}

const SHAFT: &str = ";S,EX:0,EY:0,ASE:90
    ;LU,EY:30
    ;F,LFASE:1.5
    ;LL,EX:-22
    ;AB,IDX:4
    ;LU,EY:46
    ;R,RROUND:2
    ;LL,EX:-40
    ;LA,EX:-52,ASE:150
    ;LL,EX:-60";

#[test]
fn the_whole_contour_as_computed_by_hand() {
    assert_eq!(
        words(SHAFT, 2.0),
        [
            "G0 0 0",
            "G1 0 30 CHR1.5",
            "G1 -19.5 30",
            "G1 -20.62 29.4 RND0.6",
            "G1 -22 29.4 RND0.6",
            "G1 -22 46 RND2",
            "G1 -40 46",
            "G1 -52 59.856",
            "G1 -60 59.856",
        ]
    );
    // An allowance on the first cylinder.
    let raised = SHAFT.replace("LL,EX:-22", "LL,EX:-22,DST:.1");
    let list = words(&raised, 2.0);
    assert_eq!(list[1..5], ["G1 0 30.2 CHR1.6", "G1 -19.127 30.2", "G1 -20.62 29.4 RND0.6", "G1 -22 29.4 RND0.6"]);
}

#[test]
fn start_transitions() {
    assert_eq!(words(";S,EX:0,EY:52,ASE:270\n;F,LFASE:1\n;LL,EX:-5", 2.0)[..2], ["G0 0 54", "G1 0 52 CHR1"]);
    let list = words(";S,EX:0,EY:52,ASE:270\n;R,RROUND:.8\n;LA,EX:-30,EY:46", 2.0);
    assert_eq!(list, ["G0 0 53.448", "G1 0 52 RND0.8", "G1 -30 46"]);
    assert_eq!(words(";S,EX:0,EY:52,ASE:270\n;R,RROUND:0\n;LL,EX:-5", 2.0), ["G0 0 52", "G1 -5 52"]);
}

#[test]
fn an_open_line_ends_on_the_next_arc() {
    let text = ";S,EX:-3,EY:20\n;LU,DIA:225/0\n;ACW,EX:0,EY:40,CY:30,RAD:5";
    assert_eq!(words(text, 2.0), ["G0 -3 20", "G1 -3 22", "G2 0 40 AC 0 30"]);
    let far = text.replace("225", "25");
    assert_eq!(words(&far, 2.0)[1], "G1 -3 38");
    assert_eq!(solve(&records(&far), DIAMETERS, &Undercuts::default()).map(|c| c.chosen), Ok(vec![1]));
    let open = text.replace(",DIA:225/0", "");
    assert_eq!(solve(&records(&open), DIAMETERS, &Undercuts::default()), Err(Unsolved::Open(1)));
}

#[test]
fn an_open_line_ends_where_the_next_one_has_its_own_way() {
    let text = ";S,EX:0,EY:100\n;LL,EX:-20\n;LU\n;LA,DEX:-3,EY:160,ASE:150";
    assert_eq!(words(text, 2.0), ["G0 0 100", "G1 -20 100", "G1 -20 156.536", "G1 -23 160"]);
    let wrong_way = text.replace("ASE:150", "ASE:30");
    assert_eq!(solve(&records(&wrong_way), DIAMETERS, &Undercuts::default()), Err(Unsolved::Open(2)));
}

#[test]
fn a_tangential_arc_ends_in_the_direction_of_the_next_line() {
    let text = ";S,EX:0,EY:36\n;LL,EX:-18\n;R,RROUND:3\n;ACW,AT:0,RAD:4\n;LA,EY:70,ASE:120";
    assert_eq!(words(text, 2.0), ["G0 0 36", "G1 -18 36", "G2 -21.464 40 AC -18 44", "G1 -30.124 70"]);
}

#[test]
fn other_ways_to_give_an_arc() {
    // Opening angle; centre coordinate on the bisector; end angle.
    assert_eq!(words(";S,EX:10,EY:0\n;ACCW,CX:0,CY:0,AA:90", 1.0)[1], "G3 0 10 AC 0 0");
    assert_eq!(words(";S,EX:10,EY:0\n;ACCW,EX:0,EY:10,CX:0", 1.0)[1], "G3 0 10 AC 0 0");
    assert_eq!(words(";S,EX:10,EY:0\n;ACCW,CX:0,CY:0,ASE:180", 1.0)[1], "G3 0 10 AC 0 0");
    assert_eq!(words(";S,EX:10,EY:0\n;ACCW,CX:0,CY:0,EX:6,DIA:207/0", 1.0)[1], "G3 6 -8 AC 0 0");
    assert_eq!(words(";S,EX:10,EY:0\n;ACW,EX:6,EY:-8,RAD:10", 1.0)[1], "G2 6 -8 AC 0 0");
    assert_eq!(words(";S,EX:0,EY:0\n;LR,EX:5\n;ACCW,AT:0,EX:8,EY:3", 1.0)[2], "G3 8 3 AC 5 3");
}

#[test]
fn a_line_may_end_where_the_next_arc_has_its_ordinate() {
    let text = ";S,EX:0,EY:0\n;LA,EY:-10,ATT:APP(ALLPARA)\n;ACCW,DIA:0/17,EX:20,EY:-10,CX:10,CY:-10";
    assert_eq!(words(text, 1.0), ["G0 0 0", "G1 0 -10", "G3 20 -10 AC 10 -10"]);
}

#[test]
fn what_is_not_determined_is_not_guessed() {
    let fails = |text: &str| solve(&records(text), DIAMETERS, &Undercuts::default()).expect_err("unsolved");
    assert_eq!(fails(";LL,EX:5"), Unsolved::NoStart);
    assert_eq!(fails(";S,EX:0,EY:0\n;LL"), Unsolved::Open(1));
    assert_eq!(fails(";S,EX:0,EY:0\n;LA,EX:5"), Unsolved::Open(1));
    assert_eq!(fails(";S,EX:0,EY:0\n;LL,EX:5"), Unsolved::Contradiction(1));
    assert_eq!(fails(";S,EX:0,EY:0\n;POL,EX:5"), Unsolved::Unknown(1));
    assert_eq!(fails(";S,EX:0,EY:0\n;LA,EX:5,L:3"), Unsolved::Unknown(1));
    assert_eq!(fails(";S,EX:0,EY:0\n;ACW,EX:5,EY:0,RAD:1"), Unsolved::Contradiction(1));
    assert_eq!(fails(";S,EX:0,EY:20\n;LL,EX:-9\n;AB,FRM:3\n;LU,EY:60"), Unsolved::Undercut(2, NoUndercut::Free));
    assert_eq!(fails(";S,EX:0,EY:20\n;LL,EX:-9\n;AB,IDX:99\n;LU,EY:60"), Unsolved::Undercut(2, NoUndercut::Index(99)));
    let thread = |keys: &str| fails(&format!(";S,EX:0,EY:20\n;LL,EX:-40\n;AB,FRM:2{keys}\n;LU,EY:60"));
    assert_eq!(
        thread(",ALFA:30"),
        Unsolved::Undercut(2, NoUndercut::PitchMissing { diameter: 20.0, surface: Surface::External })
    );
    assert_eq!(thread(",P:2.6,ALFA:30"), Unsolved::Undercut(2, NoUndercut::Pitch(2.6)));
    assert_eq!(thread(",P:2.5"), Unsolved::Undercut(2, NoUndercut::Entry(None)));
    assert_eq!(thread(",P:2.5,ALFA:29"), Unsolved::Undercut(2, NoUndercut::Entry(Some(29.0))));
    assert_eq!(solve(&vec![Record::Begin; 5001], DIAMETERS, &Undercuts::default()), Err(Unsolved::TooLong));
}

#[test]
fn differences_are_found() {
    let made = solve(&records(SHAFT), DIAMETERS, &Undercuts::default()).expect("a contour");
    let check = |spoil: &dyn Fn(&mut Vec<ContourBlock>)| {
        let mut blocks = made.blocks.clone();
        spoil(&mut blocks);
        compare(made.start, &blocks, &made, 1e-3)
    };
    assert_eq!(check(&|_| ()), Ok(()));
    assert_eq!(check(&|b| b[1].end.x += 0.0009), Ok(()));
    assert_eq!(check(&|b| b[1].end.x += 0.002), Err(Difference::End(1)));
    assert_eq!(check(&|b| b[0].corner = Some(CornerWord::Radius(1.5))), Err(Difference::Corner(0)));
    assert_eq!(check(&|b| b[2].arc = Some((Point2::origin(), true))), Err(Difference::Arc(2)));
    assert_eq!(check(&|b| b.truncate(3)), Err(Difference::Count));
    assert_eq!(compare(Point2::new(1.0, 0.0), &made.blocks, &made, 1e-3), Err(Difference::Start));
}
