//! Effects that leave no kernel.

forms::forms! {
    pub kernel twice(sigma) = exp(-sigma) effects { absorption: sigma = 0; absorption: sigma = 1; };
    pub kernel free(sigma) = exp(-sigma) effects { absorption: tau = 0; };
    pub kernel own(sigma) = exp(-sigma) effects { absorption: sigma = sigma/2; };
    pub kernel pole(sigma) = 1/sigma effects { absorption: sigma = 0; };
    pub kernel outside(sigma) = 1 - exp(-sigma) effects { absorption: sigma = 0; } where sigma > 0;
}

fn main() {
    println!("{}", pole(1.0));
}
