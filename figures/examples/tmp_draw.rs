fn main() {
    for id in std::env::args().skip(1) {
        let f = figures::catalog::find(&id).unwrap();
        std::fs::write(format!("/tmp/exp_fig_{id}.svg"), f.draw(&Default::default()).unwrap()).unwrap();
    }
}
