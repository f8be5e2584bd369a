use super::*;

fn plot(points: Vec<[f64; 2]>) -> Plot {
    Plot {
        title: "a < b".into(),
        description: "growth".into(),
        x_name: "n".into(),
        x_scale: Scale::Logarithmic,
        y_name: "operations".into(),
        curves: vec![Curve {
            name: "method".into(),
            notes: vec!["3 n".into()],
            fit: points.clone(),
            points,
            look: Look::of_series(0),
        }],
        naming: Naming::Apart,
    }
}

fn drawn() -> String {
    plot(vec![[64.0, 192.0], [128.0, 384.0], [1024.0, 3072.0]]).draw().expect("positive points")
}

/// The value of an attribute in the first element that starts with `opening`.
fn attribute<'a>(document: &'a str, opening: &str, name: &str) -> &'a str {
    let element = document.split_once(opening).expect("the element is drawn").1;
    let element = element.split_once('>').expect("it is closed").0;
    let value = element.split_once(&format!("{name}=\"")).expect("it has the attribute").1;
    value.split_once('"').expect("it is quoted").0
}

#[test]
fn text_is_escaped_and_written_in_a_generic_font() {
    let drawn = drawn();
    assert!(drawn.contains("<title>a &lt; b</title>"));
    assert!(drawn.contains("\n100\n") && drawn.contains("\n1000\n") && drawn.contains("3 n"));
    assert_eq!(drawn.matches("<text").count(), drawn.matches("font-family=\"sans-serif\"").count());
}

#[test]
fn points_of_slope_one_rise_as_fast_as_they_go_right_in_decades() {
    let drawn = drawn();
    let fit = attribute(&drawn, "<polyline fill=\"none\" opacity=\"1\" stroke=\"#0072B2\"", "points");
    let corners: Vec<f64> = fit.split([' ', ',']).filter_map(|number| number.parse().ok()).collect();
    let [x0, y0, x1, y1, x2, y2] = corners[..] else { panic!("three points, got {corners:?}") };
    let (first, second) = ((y0 - y1) / (x1 - x0), (y1 - y2) / (x2 - x1));
    assert!((first / second - 1.0).abs() < 0.01, "{corners:?}");
}

#[test]
fn a_long_legend_makes_the_page_longer() {
    let mut long = plot(vec![[64.0, 192.0], [128.0, 384.0]]);
    long.curves[0].notes.extend((0..40).map(|line| format!("line {line}")));
    let document = long.draw().expect("positive points");
    let height: f64 = attribute(&document, "<svg", "height").parse().expect("a number");
    assert!(height > 41.0 * legend::LINE);
    for y in document.match_indices("<text ").map(|(at, _)| attribute(&document[at..], "<text", "y")) {
        assert!(y.parse::<f64>().expect("a number") < f64::from(FINENESS) * height);
    }
}

#[test]
fn what_has_no_place_is_refused() {
    assert!(matches!(plot(vec![]).draw(), Err(FigureError::EmptySeries(_))));
    assert!(matches!(plot(vec![[1.0, 0.0]]).draw(), Err(FigureError::NoPlace([1.0, 0.0]))));
    assert!(matches!(plot(vec![[f64::NAN, 1.0]]).draw(), Err(FigureError::NoPlace(_))));
    let linear = Plot { x_scale: Scale::Linear, ..plot(vec![[0.0, 1.0], [3.0, 2.0]]) };
    assert!(linear.draw().is_ok(), "zero has a place on a linear axis");
    let empty = Plot { curves: vec![], ..plot(vec![]) };
    assert!(matches!(empty.draw(), Err(FigureError::NoSeries)));
}

#[test]
fn series_of_one_name_stand_below_it_in_columns() {
    let one = plot(vec![[64.0, 192.0], [128.0, 384.0]]);
    let member = |method: usize, input: usize| {
        let mut curve = Curve { name: format!("method {method}"), ..one.curves[0].clone() };
        curve.notes = vec![format!("input {input}"), "exponent 1".to_owned()];
        curve
    };
    let curves = (0..12).flat_map(|method| (0..7).map(move |input| member(method, input))).collect();
    let document = Plot { curves, naming: Naming::Grouped, ..one }.draw().expect("positive points");
    assert_eq!(document.matches("\nmethod 11\n").count(), 1);
    assert_eq!(document.matches("\ninput 6: exponent 1\n").count(), 12);
    let [width, height] =
        ["width", "height"].map(|name| attribute(&document, "<svg", name).parse::<f64>().expect("a number"));
    assert!(height < 660.0 && width > PLOT_WIDTH + 300.0, "{width} × {height}");
}
