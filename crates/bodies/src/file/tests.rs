//! Bodies read from files, and what is said of those that cannot be.

use super::*;
use std::path::Path;

fn body(text: &str) -> Result<BodyModel, Error> {
    BodyModel::from_toml(text, Path::new(""))
}

/// Two points on x: a quarter turn about z takes their centre from x to y.
#[test]
fn a_part_that_is_turned_takes_its_centre_along() {
    // Of an axis the direction alone counts, however long it is, and whole turns do not count.
    let part = "[[part]]\npoints = [[1, 0.5, 0, 0], [1, 1.5, 0, 0]]\nturn = [0, 0, 1e200, 360000000000090]\nat = [0, 0, 3]";
    let other = "[[part]]\nsides = [1, 2, 3]\nmass = 2\nturn = [0, 1e-200, 0, 90]";
    let found = body(&format!("{part}\n{other}")).unwrap();
    assert!((found.centre - Vector3::new(0.0, 0.5, 1.5)).norm() < 1e-15, "{}", found.centre);
}

#[test]
fn what_is_wrong_is_named_with_its_line_and_its_field() {
    for (text, words) in [
        ("sides = [1, 2, 3]", "line 1, `sides`: `mass` (kg) or `density` (kg/m³) is missing"),
        ("mass = 1", "line 1: what the body is is missing"),
        ("sides = [1, -2, 3]\nmass = 1", "line 1, `sides`: the edge along y is -2.0: it must be"),
        ("sides = [1, 2]\nmass = 1", "line 1, `sides`: 3 numbers are expected here, not 2"),
        ("mass = 1\nshape = 'bal'\nradius = 1", "line 2, `shape`: no shape is called `bal`; there"),
        ("mass = 1\nshape = 'tube'\nradius = 1", "; a tube is a cylinder with `inner`"),
        ("mass = '12.5'\nsides = [1, 2, 3]", "not `12.5`: the unit is missing"),
        ("body = 'book'\nturn = { x = 1 }", "`turn`: a list is expected here, not map; write turn = [x, y"),
        ("mass = 1\nshape = 'ball'\nheight = 1", "line 3, `height`: it does not go with `ball`, which"),
        ("mass = 1\nshape = 'rod'\ninner = 1", "with `rod`, which takes `length`, `mass`, `density`\n"),
        ("mass = 1\nshape = 'cone'\nheight = 1", "line 2, `shape`: `radius` is missing"),
        ("moments = [1, 2, 3.1]", "line 1, `moments`: no body has principal moments"),
        ("moments = [1, 2, 3.0001]", "; if its digits were rounded, `tolerance` says by how much"),
        ("density='7 kg/m3'\nshape='disk'\nradius=1", "`density`: a number in kg/m² is expected here"),
        ("density = '7 kg'\nsides = [1, 2, 3]", "such as \"0.7 g/cm3\" (g/cm3, kg/m3), not `7 kg`"),
        ("sides = ['1 m', '2 g', 3]\nmass = 1", "line 1, `sides`: a number is expected here, or one"),
        ("shape = 'ball'\nradius = 0,07\nmass = 1", "; write 0.07"),
        ("shape = 'ball'\nradius = '7,5 cm'\nmass = 1", "not `7,5 cm`; write '7.5 cm'"),
        ("shape = 'ball'\nradius = '0,07'\nmass = 1", "not `0,07`; write 0.07, unquoted"),
        ("sides = [7,7, 0.78, 16]\nmass = 1", "3 numbers are expected here, not 4; write 7.7"),
        ("sides = [1, 2, 3]\nmass = 1\nat = [1,2]", "`at`: 3 numbers are expected here, not 2\n"),
        ("[part]\nmass = 1\n[part]\nmass = 2", "line 3: this is there already; each table of a list begins"),
        ("moments = [1, 2, 2.5]\nproducts = [0, 0, 0, 1]", "line 2, `products`: 3 numbers are expected"),
        ("points = [[1, 0, 0, 0, 9]]", "line 1, `points`: 4 numbers are expected here, not 5"),
        ("shape = 'tetrahedron'\nvertices = [[0, 0, 0]]", "line 2, `vertices`: 4 lists of 3 numbers"),
        ("mass=1\nshape='tetrahedron'\nvertices=[[0,0,0],[1,0,0],[0,1,0],[1,1,0]]", "`vertices`: the volume"),
        ("shape = 3", "line 1, `shape`: a string is expected here, not integer `3`"),
        ("[[part]]\nmass = [1]", "line 2, `mass`: a number is expected here, or a text with its unit"),
        ("[[part]]\nmomets = [1]", "line 2, `momets`: no such field. Did you mean `moments`?"),
        ("[[part]]\nmoments = [1, 2, 3]", "line 1: `mass` (kg) is missing"),
        ("mass = 1\nshape = 'rod'\nlength = 1", "line 2, `shape`: the smallest principal moment, 0.0"),
        ("moments = [0, 0, 0]\nproducts = [0.1, 0, 0]", "line 1, `moments`: the largest moment of"),
        ("moments = [1, 2, 2.5]\nproducts = [5, 0, 0]", "line 2, `products`: the smallest principal"),
        ("[part]\nsides = [1, 2, 3]", "`part`: a list is expected here, not map: each table"),
        ("[[body]]\nmoments = [1, 2, 3]", "line 1, `body`: a string is expected here, not sequence: each"),
        ("[[part]]\nsides = [1, 2, 3]\nmass = 1\nspin = 1", "line 4, `spin`: it is the whole body's"),
        ("mass = 1\nname = \"a\\u0000b\"\nsides = [1, 2, 3]", "line 2, `name`: '\\0' is not a character"),
        (&format!("name = '{}'\nmoments = [1, 2, 2]", "n".repeat(2_000_000)), "`name`: a name of 2000000"),
        ("sides = [1, 2, 3]\nmass = 1\nattitude = [1, 0, 0, 0]", "line 3, `attitude`: it is of a body"),
        ("moments = [1, 2, 1e-400]", "line 1, `moments`: 1e-400 is too near zero"),
        ("sides = [1, 2, 3]\nmass = 90_000_000_000_000_000_000", "`mass`: 90000000000000000000 is too long"),
        ("sides = [1, 2, 3]\nmass = 1\nat = [1e10, 0, 0]", "line 3, `at`: so far away that rounding"),
    ] {
        let error = format!("{}\n", body(text).unwrap_err());
        assert!(error.contains(words), "{text}\n{error}");
    }
    // The commas between the numbers of a list are none.
    assert!(body("moments = [[1,0,0],[0,2,0],[0,0,3]]").unwrap_err().why.ends_with("not sequence"));
}

#[test]
fn a_size_or_a_mass_may_have_its_unit_and_a_number_that_lacks_it_is_questioned() {
    let metres = body("sides = [0.077, 0.0078, 0.16]\nmass = 0.2").unwrap();
    let mixed = body("sides = ['77 mm', '7.8mm', '16 cm']\nmass = '200 g'").unwrap();
    let [mixed_tensor, tensor] = [&mixed, &metres].map(|body| body.inertia.matrix());
    assert!((mixed_tensor - tensor).amax() < 1e-15 * tensor.amax());
    assert_eq!((mixed.mass, mixed.question, metres.question), (Some(0.2), None, None));
    for (sides, mass, units) in [
        ("7.7, 0.78, 16", "0.2", "cm and kg, or in mm and g"),
        ("7.7, 0.78, 16", "200", "cm and g"),
        ("77, 7.8, 160", "200", "mm and g, or in cm and kg"),
        ("0.077, 0.0078, 0.16", "200", "m and g"),
    ] {
        let question = |head| body(&format!("{head}sides = [{sides}]\nmass = {mass}")).unwrap().question;
        let asked = format!("{mass} kg in {} m: is this in {units}?", sides.replace(',', " m ×"));
        assert_eq!([question(""), question("[[part]]\n")], [Some(asked.clone()), Some(asked)]);
    }
    for (text, asked) in [
        ("radius = 33\nmass = 0.058", "0.058 kg in 33 m: is this in mm and kg?"),
        ("radius = '33 mm'\nmass = 58", "58 kg in 33 mm: is this in g?"),
        ("radius = 33\nmass = '58 g'", "58 g in 33 m: is this in mm?"),
        ("radius = '3 cm'\nmass = '300 kg'", "300 kg in 3 cm: NONE"),
        ("radius = '1 mm'\nmass = 0.2", "0.2 kg in 1 mm: NONE"),
        ("radius = 1\ndensity = 90000", "90000 kg/m³: NONE"),
        ("radius = 1\ndensity = 0.7", "0.7 kg/m³: is this in g/cm3?"),
        ("radius = 1\nmass = 1e30", "1e30 kg in 1 m: NONE"),
    ] {
        let asked = asked.replace("NONE", "no solid is so light or so heavy. Are the numbers right?");
        assert_eq!(body(&format!("shape = 'ball'\n{text}")).unwrap().question.unwrap(), asked);
    }
    let one = body("sides = ['77 mm', 7.8, '160 mm']\nmass = '200 g'").unwrap().question.unwrap();
    assert_eq!(one, "200 g in 77 mm × 7.8 m × 160 mm: is this in mm, or in cm?");
    // A head of 3 cm on a handle of 34 cm, its place without a unit.
    let text = "[[part]]\nshape = 'ball'\nradius = '3 cm'\nmass = '0.1 kg'\nat = [0, 0, AT]\n[[part]]\nsides = ['3 cm', '3 cm', '34 cm']\nmass = '0.1 kg'";
    let racket = |at| body(&text.replace("AT", at)).unwrap().question;
    assert_eq!(racket("0.2"), None);
    let far = racket("-1.2").unwrap();
    assert_eq!(far, "a part 0.06 m large lies 1 m from the others: is its place in cm, or in mm?");
    let part = "[[part]]\nsides = [1, 2, 3]\nmass = 6000\n";
    let twice = body(&part.repeat(2)).unwrap().question.unwrap();
    assert_eq!(twice, "part 2 equals another in the same place: is it written twice?");
    assert_eq!(body(&format!("{part}{part}at = [0, 2, 0]")).unwrap().question, None);
    let wood = body("sides = [1, 2, 3]\ndensity = '0.7 g/cm3'").unwrap();
    assert!((wood.mass.unwrap() - 4200.0).abs() < 1e-9 && wood.question.is_none());
    // A satellite is light, and of a thin plate nothing is known.
    for text in [
        "sides = [2, 2, 4]\nmass = 160",
        "sides = [0.077, # m, wide\n0.0078, 0.16,]\nmass = 0.2",
        "points = [[1, 0, 0, 0], [2, 5, 0, 0], [1, 0, 4, 0]]",
        "body = 'book'\nturn = [0, 0, 1, 1.5]",
        "body = 'book'\nturn = [0, 0, 1, 3]",
        "body = 'book'\nturn = [0, 0, 1, 5.5]",
        "shape = 'plate'\nsides = [2, 1]\nmass = 0.001",
        "shape = 'tetrahedron'\nvertices = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 6]]\nmass = 20000",
    ] {
        assert_eq!(body(text).unwrap().question, None, "{text}");
    }
    for (text, words) in [
        ("points = [[0.1, 77, 0, 0], [0.1, 0, 60, 0], [0.2, 0, 0, 9]]", "need 5.8e-7 kg/m³. Are the units"),
        ("points = [[0.1, 7.7, 0, 0], [0.1, 0, 6, 0], [0.2, 0, 0, 1]]", " kg/m³. Are the units right?"),
        ("body = 'book'\nturn = [0, 0, 1, 1.5708]", "by 1.5708° is small: is this in rad? In degrees"),
        ("body = 'book'\nturn = [0, 0, 1, -0.79]", "in rad? In degrees it is -45"),
        ("body = 'book'\nturn = [0, 0, 1, 6.28]", "is 360, which is no turn"),
        ("points = [[1e300, 1, 0, 0], [1e300, 0, 1, 0], [1e300, 0, 0, 1]]", "3e300 kg and moments up"),
        ("moments = [1, 1, 1]\nmass = 1e300\nsides = [1, 1, 1]", "1e300 kg and moments up to 1 kg m². Are"),
        ("moments = [1e-6, 1e-6, 1e-6]\nmass = 1000", "a ball with these would need 1.9e15 kg/m³. Are"),
        ("moments = [9, 9, 9]\nmass = 1\nsides = [0.2, 0.2, 0.1]", "of 3 m; the drawing reaches 0.15 m. Are"),
    ] {
        assert!(body(text).unwrap().question.unwrap().contains(words), "{text}");
    }
}

/// Each field of each kind of body, made bad in turn.
#[test]
fn the_field_that_is_made_bad_is_the_field_that_is_named() {
    for (good, bad) in [
        ("sides = [1, 2, 3]\nmass = 1", &[("sides", "[1, 2, -3]"), ("mass", "-1"), ("mass", "inf")][..]),
        ("sides = [1, 2, 3]\ndensity = 1", &[("density", "-1"), ("density", "1e308")]),
        ("shape = 'ball'\nradius = 2\ninner = 1\nmass = 1", &[("radius", "-1"), ("inner", "3")]),
        (
            "name = 'probe 1e-300'\nshape = 'ball'\nradius = 2\nmass = 1e300\nspin = 1e-200",
            &[("radius", "-1"), ("radius", "1e-150"), ("mass", "0")],
        ),
        ("shape = 'capsule'\nradius = 2\nlength = 1\nmass = 1", &[("radius", "0"), ("length", "-1")]),
        ("shape = 'cone'\nradius = 2\nheight = 1\nmass = 1", &[("radius", "0"), ("height", "nan")]),
        (
            "shape = 'cylinder'\nradius = 2\nheight = 1\ninner = 1\nmass = 1",
            &[("radius", "inf"), ("height", "-1"), ("inner", "-1"), ("radius", "1e120"), ("height", "1e120")],
        ),
        ("shape = 'disk'\nradius = 2\ndensity = 1", &[("radius", "-2"), ("density", "inf")]),
        ("shape = 'ellipsoid'\nsemiaxes = [1, 2, 3]\nmass = 1", &[("semiaxes", "[1, 0, 3]")]),
        ("shape = 'plate'\nsides = [1, 2]\nmass = 1", &[("sides", "[0, 1]"), ("mass", "nan")]),
        (
            "shape = 'tetrahedron'\nvertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]\nmass = 1",
            &[("vertices", "[[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, inf]]"), ("mass", "-1")],
        ),
        ("points = [[1, 0, 0, 0], [1, 1, 0, 0], [1, 0, 1, 0]]", &[("points", "[[0, 1, 2, 3]]")]),
        (
            "moments = [2, 3, 4]\nproducts = [0, 0.1, 0]\ntolerance = 0.1\nmass = 1\nsides = [1, 1, 1]",
            &[("moments", "[2,-3,4]"), ("products", "[0,inf,0]"), ("tolerance", "-1"), ("sides", "[1,1,0]")],
        ),
        (
            "mass = 1\nmesh = 'corner.obj'\nunit = 1",
            &[("mass", "-1"), ("unit", "0"), ("unit", "1e308"), ("mesh", "'flipped.obj'")],
        ),
        ("mesh = 'corner.obj'\nunit = 1\ndensity = 1", &[("density", "-1"), ("unit", "1e200")]),
        (
            "urdf = 'arm.urdf'\nlink = 'arm'\ntolerance = 0.1",
            &[("urdf", "'none'"), ("link", "'leg'"), ("tolerance", "-1"), ("tolerance", "nan")],
        ),
        ("sides = [1, 2, 3]\ndensity = 1", &[("sides", "[1e101,1,1]"), ("sides", "[1e-105,1e-105,1e-105]")]),
        ("moments = [2, 3, 4]\nmass = 1", &[("moments", "[1e308, 1e308, 1e308]"), ("mass", "1e-250")]),
        ("moments = [2, 3, 4]\nmass = 1", &[("moments", "[2, nan, 4]"), ("mass", "0")]),
        ("moments = [2, 3, 4]", &[("moments", "[1e308, 1e308, 1e308]")]),
        (
            "body = 'book'\nspin = 1\nat = [1, 0, 0]\nturn = [1, 0, 0, 30]",
            &[("body", "'page'"), ("spin", "-1"), ("at", "[inf, 0, 0]"), ("turn", "[0, 0, 0, 1]")],
        ),
    ] {
        let body = |text: &str| BodyModel::from_toml(text, Path::new("tests/files"));
        body(good).unwrap_or_else(|error| panic!("{good}: {error}"));
        for (field, value) in bad {
            let mut lines = good.lines().enumerate();
            let (line, given) = lines.find(|(_, it)| it.split_once(" = ").unwrap().0 == *field).unwrap();
            let text = good.replacen(given, &format!("{field} = {value}"), 1);
            let error = body(&text).unwrap_err();
            let place = (error.line, error.field.as_deref());
            assert_eq!(place, (Some(line + 1), Some(*field)), "{text}: {error}");
        }
    }
}

/// A mark of UTF-8 before the first vertex does not hide it.
#[test]
fn a_marked_mesh_has_all_its_vertices() {
    let body_in = |text: &str| BodyModel::from_toml(text, Path::new("tests/files"));
    let mesh = |name| body_in(&format!("mesh = '{name}'\nmass = 1"));
    assert_eq!(mesh("marked.obj").unwrap(), mesh("corner.obj").unwrap());
    let asked = body_in("mesh = 'corner.obj'\nmass = 1.6e-5").unwrap().question.unwrap();
    assert_eq!(asked, "0.000016 kg in 16 m³: is the mesh in mm, `unit = 0.001`?");
    for (text, words) in
        [("density = 7.8", "7.8 kg/m³: is this in g/cm3?"), ("mass = 1\nunit = 1", ": no solid is so")]
    {
        let asked = body_in(&format!("mesh = 'corner.obj'\n{text}\n")).unwrap().question.unwrap();
        assert!(asked.contains(words), "{asked}");
    }
    // A vertex of its own for each face, as many programs write them, is as closed.
    assert_eq!(mesh("doubled.obj").unwrap().inertia, mesh("corner.obj").unwrap().inertia);
    assert_eq!(mesh("endless.obj").unwrap_err().why, "a number of a vertex is not finite");
}

#[test]
fn what_would_take_minutes_or_the_stack_is_refused_with_its_count() {
    let part = "[[part]]\nsides = [1, 2, 3]\nmass = 1\n";
    let error = body(&part.repeat(20_000)).unwrap_err();
    assert!(error.why.starts_with("20000 parts: at most 10000"), "{error}");
    let nested = |depth: usize| {
        let heads = (1..depth).map(|k| format!("[[{}]]\n", vec!["part"; k].join("."))).collect::<String>();
        body(&format!("{heads}sides = [1, 2, 3]\nmass = 1\n"))
    };
    assert!(nested(30).is_ok());
    assert!(nested(31).unwrap_err().why.starts_with("31 bodies, one the part of the other: at most 30"));
    assert!(nested(1000).is_err());
    for depth in [1000, 20_000] {
        assert!(body(&format!("part = {}{}", "[".repeat(depth), "]".repeat(depth))).is_err());
        assert!(body(&format!("[{}]", vec!["part"; depth].join("."))).is_err());
        assert!(body(&format!("{}x = 1{}", "part = [{ ".repeat(depth), " }]".repeat(depth))).is_err());
    }
}

#[test]
fn parts_add_up_as_a_compound_does_wherever_they_are_written() {
    let one = "[[part]]\nsides = [1, 2, 3]\ndensity = 2\nat = [0.5, 0, 0]\n";
    let pair =
        format!("{one}[[part]]\nsides = [2, 1, 3]\ndensity = 2\nturn = [0, 0, 1, 90]\nat = [-0.5, 0, 0]\n");
    let whole = body("sides = [2, 2, 3]\ndensity = 2").unwrap();
    let found = body(&pair).unwrap();
    assert!((found.inertia.matrix() - whole.inertia.matrix()).amax() < 1e-13);
    assert_eq!(found.mass, whole.mass);
    let capsule = "shape = 'capsule'\nradius = 1\nlength = 3\ndensity = 3";
    assert!((body(capsule).unwrap().mass.unwrap() - 13.0 * std::f64::consts::PI).abs() < 1e-13);
    let nested = pair.replace("[[part]]", "[[part.part]]");
    assert_eq!(body(&format!("[[part]]\nat = [0, 7, 0]\n{nested}")).unwrap().centre.y, 7.0);
}

#[test]
fn printed_moments_are_taken_within_the_tolerance_that_the_file_has() {
    let moved = body("[[part]]\nmass = 1\nmoments = [3.333, 13.33, 16.67]\ntolerance = 1e-3").unwrap().moved;
    assert!(moved > 1e-4 && moved < 1e-3);
}

#[test]
fn links_that_fixed_joints_hold_are_questioned_until_each_is_a_part() {
    let text = |rest: &str| format!("[[part]]\nurdf = 'arm.urdf'\nlink = 'arm'\n[[part]]\n{rest}");
    let asked = |rest| BodyModel::from_toml(&text(rest), Path::new("tests/files")).unwrap().question;
    let of = |link| format!("body = 'arm.urdf#{link}'\n{}", "[[part]]\nbody = 'book'\n".repeat(1200));
    let [with, without] = ["tool", "arm"].map(of);
    // By another path, as a file of a file, and as one of more parts than are compared with one another.
    for rest in ["urdf = '../files/arm.urdf'\nlink = 'tool'", "body = './arm.urdf#tool'", &with] {
        assert_eq!(asked(rest), None, "{rest}");
    }
    let twice = "urdf = 'arm.urdf'\nlink = 'tool'\n[[part]]\nat = [1, 0, 0]\nbody = 'arm.urdf#arm'";
    for rest in ["body = 'book'", "at = [1, 0, 0]\npart = [{ body = 'arm.urdf#arm' }]", twice, &without] {
        assert!(asked(rest).unwrap().starts_with("without `tool`, which fixed joints hold to it"), "{rest}");
    }
}
