//! Written by `generate.py` with SymPy 1.14.0.

use std::f64::consts::PI;

pub(crate) fn solid_angle_density_patch(u: f64, v: f64, ax: f64, ay: f64, az: f64, bx: f64, by: f64, bz: f64, cx: f64, cy: f64, cz: f64, dx: f64, dy: f64, dz: f64) -> f64 {
    let x0 = 1.0 - v;
    let x1 = 1.0 - u;
    let x2 = cx*v;
    let x3 = ax*x0;
    let x4 = bx*u*x0 + dx*u*v + x1*x2 + x1*x3;
    let x5 = by*u;
    let x6 = ay*x1;
    let x7 = cy*v*x1 + dy*u*v + x0*x5 + x0*x6;
    let x8 = bz*u;
    let x9 = az*x1;
    let x10 = cz*v*x1 + dz*u*v + x0*x8 + x0*x9;
    let x11 = -ax*x1 - bx*u + cx*x1 + dx*u;
    let x12 = -ay*x0 + by*x0 - cy*v + dy*v;
    let x13 = bx*x0 + dx*v - x2 - x3;
    let x14 = cy*x1 + dy*u - x5 - x6;
    let x15 = -az*x0 + bz*x0 - cz*v + dz*v;
    let x16 = cz*x1 + dz*u - x8 - x9;
    (x10*(-x11*x12 + x13*x14) + x4*(x12*x16 - x14*x15) + x7*(x11*x15 - x13*x16))/((x10).powi(2) + (x4).powi(2) + (x7).powi(2)).powf(3.0/2.0)
}

pub(crate) fn solid_angle_triangle(px: f64, py: f64, pz: f64, ax: f64, ay: f64, az: f64, bx: f64, by: f64, bz: f64, cx: f64, cy: f64, cz: f64) -> f64 {
    let x0 = -px;
    let x1 = ax + x0;
    let x2 = -py;
    let x3 = by + x2;
    let x4 = -pz;
    let x5 = cz + x4;
    let x6 = bz + x4;
    let x7 = cy + x2;
    let x8 = ay + x2;
    let x9 = bx + x0;
    let x10 = cx + x0;
    let x11 = az + x4;
    let x12 = ((x10).powi(2) + (x5).powi(2) + (x7).powi(2)).sqrt();
    let x13 = ((x3).powi(2) + (x6).powi(2) + (x9).powi(2)).sqrt();
    let x14 = ((x1).powi(2) + (x11).powi(2) + (x8).powi(2)).sqrt();
    2.0*(x1*(x3*x5 - x6*x7) + x11*(-x10*x3 + x7*x9) + x8*(x10*x6 - x5*x9)).atan2(x12*x13*x14 + x12*(x1*x9 + x11*x6 + x3*x8) + x13*(x1*x10 + x11*x5 + x7*x8) + x14*(x10*x9 + x3*x7 + x5*x6))
}

pub(crate) fn form_factor_point_rectangle(px: f64, py: f64, pz: f64, nx: f64, ny: f64, nz: f64, ox: f64, oy: f64, oz: f64, ux: f64, uy: f64, uz: f64, vx: f64, vy: f64, vz: f64) -> f64 {
    let x0 = oy - py;
    let x1 = ox - px;
    let x2 = oz - pz;
    let x3 = nx*x1 + ny*x0 + nz*x2;
    let x4 = x3 > 0.0;
    let x5 = uy + x0;
    let x6 = x3.abs();
    let x7 = ux + x1;
    let x8 = uz + x2;
    let x9 = nx*x7 + ny*x5 + nz*x8;
    let x10 = x9.abs();
    let x11 = x0*x10 + x5*x6;
    let x12 = if (x4) {
    x0
} else {
    x11
};
    let x13 = x9 > 0.0;
    let x14 = x10*x2 + x6*x8;
    let x15 = if (x13) {
    x8
} else {
    x14
};
    let x16 = if (x4) {
    x2
} else {
    x14
};
    let x17 = if (x13) {
    x5
} else {
    x11
};
    let x18 = x12*x15 - x16*x17;
    let x19 = x1*x10 + x6*x7;
    let x20 = if (x4) {
    x1
} else {
    x19
};
    let x21 = if (x13) {
    x7
} else {
    x19
};
    let x22 = -x15*x20 + x16*x21;
    let x23 = -x12*x21 + x17*x20;
    let x24 = ((x18).powi(2) + (x22).powi(2) + (x23).powi(2)).sqrt();
    let x25 = x13 && x4;
    let x26 = if (if (x25) {
    ((-x0*x7 + x1*x5).powi(2) + (x0*x8 - x2*x5).powi(2) + (-x1*x8 + x2*x7).powi(2)).sqrt() > 0.0
} else {
    if (x4) {
        ((x0*x14 - x11*x2).powi(2) + (-x0*x19 + x1*x11).powi(2) + (-x1*x14 + x19*x2).powi(2)).sqrt() > 0.0
    } else {
        if (x13) {
            ((-x11*x7 + x19*x5).powi(2) + (x11*x8 - x14*x5).powi(2) + (x14*x7 - x19*x8).powi(2)).sqrt() > 0.0
        } else {
            false
        }
    }
}) {
    (nx*x18 + ny*x22 + nz*x23)*x24.atan2(x12*x17 + x15*x16 + x20*x21)/x24
} else {
    0.0
};
    let x27 = vy + x0;
    let x28 = vx + x1;
    let x29 = vz + x2;
    let x30 = nx*x28 + ny*x27 + nz*x29;
    let x31 = x30.abs();
    let x32 = x0*x31 + x27*x6;
    let x33 = if (x4) {
    x0
} else {
    x32
};
    let x34 = x30 > 0.0;
    let x35 = x2*x31 + x29*x6;
    let x36 = if (x34) {
    x29
} else {
    x35
};
    let x37 = if (x4) {
    x2
} else {
    x35
};
    let x38 = if (x34) {
    x27
} else {
    x32
};
    let x39 = -x33*x36 + x37*x38;
    let x40 = x1*x31 + x28*x6;
    let x41 = if (x4) {
    x1
} else {
    x40
};
    let x42 = if (x34) {
    x28
} else {
    x40
};
    let x43 = x36*x41 - x37*x42;
    let x44 = x33*x42 - x38*x41;
    let x45 = ((x39).powi(2) + (x43).powi(2) + (x44).powi(2)).sqrt();
    let x46 = x34 && x4;
    let x47 = if (if (x46) {
    ((x0*x28 - x1*x27).powi(2) + (-x0*x29 + x2*x27).powi(2) + (x1*x29 - x2*x28).powi(2)).sqrt() > 0.0
} else {
    if (x4) {
        ((-x0*x35 + x2*x32).powi(2) + (x0*x40 - x1*x32).powi(2) + (x1*x35 - x2*x40).powi(2)).sqrt() > 0.0
    } else {
        if (x34) {
            ((x27*x35 - x29*x32).powi(2) + (-x27*x40 + x28*x32).powi(2) + (-x28*x35 + x29*x40).powi(2)).sqrt() > 0.0
        } else {
            false
        }
    }
}) {
    (nx*x39 + ny*x43 + nz*x44)*x45.atan2(x33*x38 + x36*x37 + x41*x42)/x45
} else {
    0.0
};
    let x48 = vy + x5;
    let x49 = vx + x7;
    let x50 = vz + x8;
    let x51 = nx*x49 + ny*x48 + nz*x50;
    let x52 = x51.abs();
    let x53 = x10*x48 + x5*x52;
    let x54 = if (x13) {
    x5
} else {
    x53
};
    let x55 = x51 > 0.0;
    let x56 = x10*x50 + x52*x8;
    let x57 = if (x55) {
    x50
} else {
    x56
};
    let x58 = if (x13) {
    x8
} else {
    x56
};
    let x59 = if (x55) {
    x48
} else {
    x53
};
    let x60 = x54*x57 - x58*x59;
    let x61 = x10*x49 + x52*x7;
    let x62 = if (x13) {
    x7
} else {
    x61
};
    let x63 = if (x55) {
    x49
} else {
    x61
};
    let x64 = -x57*x62 + x58*x63;
    let x65 = -x54*x63 + x59*x62;
    let x66 = ((x60).powi(2) + (x64).powi(2) + (x65).powi(2)).sqrt();
    let x67 = x13 && x55;
    let x68 = if (if (x67) {
    ((x48*x7 - x49*x5).powi(2) + (-x48*x8 + x5*x50).powi(2) + (x49*x8 - x50*x7).powi(2)).sqrt() > 0.0
} else {
    if (x13) {
        ((x5*x56 - x53*x8).powi(2) + (-x5*x61 + x53*x7).powi(2) + (-x56*x7 + x61*x8).powi(2)).sqrt() > 0.0
    } else {
        if (x55) {
            ((-x48*x56 + x50*x53).powi(2) + (x48*x61 - x49*x53).powi(2) + (x49*x56 - x50*x61).powi(2)).sqrt() > 0.0
        } else {
            false
        }
    }
}) {
    (nx*x60 + ny*x64 + nz*x65)*x66.atan2(x54*x59 + x57*x58 + x62*x63)/x66
} else {
    0.0
};
    let x69 = x27*x52 + x31*x48;
    let x70 = if (x34) {
    x27
} else {
    x69
};
    let x71 = x29*x52 + x31*x50;
    let x72 = if (x55) {
    x50
} else {
    x71
};
    let x73 = if (x34) {
    x29
} else {
    x71
};
    let x74 = if (x55) {
    x48
} else {
    x69
};
    let x75 = -x70*x72 + x73*x74;
    let x76 = x28*x52 + x31*x49;
    let x77 = if (x34) {
    x28
} else {
    x76
};
    let x78 = if (x55) {
    x49
} else {
    x76
};
    let x79 = x72*x77 - x73*x78;
    let x80 = x70*x78 - x74*x77;
    let x81 = ((x75).powi(2) + (x79).powi(2) + (x80).powi(2)).sqrt();
    let x82 = x34 && x55;
    let x83 = if (if (x82) {
    ((x27*x49 - x28*x48).powi(2) + (-x27*x50 + x29*x48).powi(2) + (x28*x50 - x29*x49).powi(2)).sqrt() > 0.0
} else {
    if (x34) {
        ((-x27*x71 + x29*x69).powi(2) + (x27*x76 - x28*x69).powi(2) + (x28*x71 - x29*x76).powi(2)).sqrt() > 0.0
    } else {
        if (x55) {
            ((x48*x71 - x50*x69).powi(2) + (-x48*x76 + x49*x69).powi(2) + (-x49*x71 + x50*x76).powi(2)).sqrt() > 0.0
        } else {
            false
        }
    }
}) {
    (nx*x75 + ny*x79 + nz*x80)*x81.atan2(x70*x74 + x72*x73 + x77*x78)/x81
} else {
    0.0
};
    let x84 = if (x4) {
    0.0
} else {
    if (x13) {
        x11
    } else {
        0.0
    }
};
    let x85 = if (x13) {
    x84
} else {
    if (x55) {
        x53
    } else {
        x84
    }
};
    let x86 = if (x55) {
    x85
} else {
    if (x34) {
        x69
    } else {
        x85
    }
};
    let x87 = if (x34) {
    x86
} else {
    if (x4) {
        x32
    } else {
        x86
    }
};
    let x88 = if (x4) {
    if (x13) {
        0.0
    } else {
        x14
    }
} else {
    0.0
};
    let x89 = if (x13) {
    if (x55) {
        x88
    } else {
        x56
    }
} else {
    x88
};
    let x90 = if (x55) {
    if (x34) {
        x89
    } else {
        x71
    }
} else {
    x89
};
    let x91 = if (x34) {
    if (x4) {
        x90
    } else {
        x35
    }
} else {
    x90
};
    let x92 = if (x4) {
    0.0
} else {
    if (x13) {
        x14
    } else {
        0.0
    }
};
    let x93 = if (x13) {
    x92
} else {
    if (x55) {
        x56
    } else {
        x92
    }
};
    let x94 = if (x55) {
    x93
} else {
    if (x34) {
        x71
    } else {
        x93
    }
};
    let x95 = if (x34) {
    x94
} else {
    if (x4) {
        x35
    } else {
        x94
    }
};
    let x96 = if (x4) {
    if (x13) {
        0.0
    } else {
        x11
    }
} else {
    0.0
};
    let x97 = if (x13) {
    if (x55) {
        x96
    } else {
        x53
    }
} else {
    x96
};
    let x98 = if (x55) {
    if (x34) {
        x97
    } else {
        x69
    }
} else {
    x97
};
    let x99 = if (x34) {
    if (x4) {
        x98
    } else {
        x32
    }
} else {
    x98
};
    let x100 = -x87*x91 + x95*x99;
    let x101 = if (x4) {
    0.0
} else {
    if (x13) {
        x19
    } else {
        0.0
    }
};
    let x102 = if (x13) {
    x101
} else {
    if (x55) {
        x61
    } else {
        x101
    }
};
    let x103 = if (x55) {
    x102
} else {
    if (x34) {
        x76
    } else {
        x102
    }
};
    let x104 = if (x34) {
    x103
} else {
    if (x4) {
        x40
    } else {
        x103
    }
};
    let x105 = if (x4) {
    if (x13) {
        0.0
    } else {
        x19
    }
} else {
    0.0
};
    let x106 = if (x13) {
    if (x55) {
        x105
    } else {
        x61
    }
} else {
    x105
};
    let x107 = if (x55) {
    if (x34) {
        x106
    } else {
        x76
    }
} else {
    x106
};
    let x108 = if (x34) {
    if (x4) {
        x107
    } else {
        x40
    }
} else {
    x107
};
    let x109 = x104*x91 - x108*x95;
    let x110 = -x104*x99 + x108*x87;
    let x111 = ((x100).powi(2) + (x109).powi(2) + (x110).powi(2)).sqrt();
    let x112 = x11*x56 - x14*x53;
    let x113 = -x11*x61 + x19*x53;
    let x114 = -x14*x61 + x19*x56;
    let x115 = (x113).powi(2) + (x114).powi(2);
    let x116 = -x53*x76 + x61*x69;
    let x117 = -x56*x76 + x61*x71;
    let x118 = x53*x71 - x56*x69;
    let x119 = -x11*x76 + x19*x69;
    let x120 = -x14*x76 + x19*x71;
    let x121 = x11*x71 - x14*x69;
    let x122 = -x11*x40 + x19*x32;
    let x123 = -x14*x40 + x19*x35;
    let x124 = x11*x35 - x14*x32;
    let x125 = -x32*x61 + x40*x53;
    let x126 = -x35*x61 + x40*x56;
    let x127 = x32*x56;
    let x128 = x127 - x35*x53;
    let x129 = -x32*x76 + x40*x69;
    let x130 = -x35*x76 + x40*x71;
    let x131 = -x35*x69;
    let x132 = x131 + x32*x71;
    let x133 = (x129).powi(2) + (x130).powi(2);
    (1.0/2.0)*(if (x4) {
    x26
} else {
    if (x13) {
        x26
    } else {
        0.0
    }
} + if (x34) {
    x47
} else {
    if (x4) {
        x47
    } else {
        0.0
    }
} + if (x13) {
    x68
} else {
    if (x55) {
        x68
    } else {
        0.0
    }
} + if (x55) {
    x83
} else {
    if (x34) {
        x83
    } else {
        0.0
    }
} + if (if (x13 && x34 && x4 && x55 && (x13 || x34) && (x13 || x4) && (x13 || x55) && (x34 || x4) && (x34 || x55) && (x4 || x55) && (x13 || x34 || x4) && (x13 || x34 || x55) && (x13 || x4 || x55) && (x34 || x4 || x55)) {
    false
} else {
    if (x34 && x4 && x55) {
        ((x112).powi(2) + x115).sqrt() > 0.0
    } else {
        if (x13 && x34 && x4 && x55) {
            ((x11).powi(2)*(x56).powi(2) + x115).sqrt() > 0.0
        } else {
            if (x13 && x34 && x4) {
                ((x116).powi(2) + (x117).powi(2) + (x118).powi(2)).sqrt() > 0.0
            } else {
                if (x46) {
                    ((x119).powi(2) + (x120).powi(2) + (x121).powi(2)).sqrt() > 0.0
                } else {
                    if (x13 && x34 && x55) {
                        ((x122).powi(2) + (x123).powi(2) + (x124).powi(2)).sqrt() > 0.0
                    } else {
                        if (x82) {
                            ((x125).powi(2) + (x126).powi(2) + (x128).powi(2)).sqrt() > 0.0
                        } else {
                            if (x34) {
                                ((x129).powi(2) + (x130).powi(2) + (x132).powi(2)).sqrt() > 0.0
                            } else {
                                if (x4 && x55) {
                                    ((x132).powi(2) + x133).sqrt() > 0.0
                                } else {
                                    if (x13 && x4 && x55) {
                                        (x133 + (-x127 - x131).powi(2)).sqrt() > 0.0
                                    } else {
                                        if (x25) {
                                            ((x125).powi(2) + (x126).powi(2) + (x128).powi(2)).sqrt() > 0.0
                                        } else {
                                            if (x4) {
                                                ((x122).powi(2) + (x123).powi(2) + (x124).powi(2)).sqrt() > 0.0
                                            } else {
                                                if (x67) {
                                                    ((x119).powi(2) + (x120).powi(2) + (x121).powi(2)).sqrt() > 0.0
                                                } else {
                                                    if (x55) {
                                                        ((x116).powi(2) + (x117).powi(2) + (x118).powi(2)).sqrt() > 0.0
                                                    } else {
                                                        if (x13) {
                                                            ((x112).powi(2) + (x113).powi(2) + (x114).powi(2)).sqrt() > 0.0
                                                        } else {
                                                            false
                                                        }
                                                    }
                                                }
                                            }
                                        }
                                    }
                                }
                            }
                        }
                    }
                }
            }
        }
    }
}) {
    (nx*x100 + ny*x109 + nz*x110)*x111.atan2(x104*x108 + x87*x99 + x91*x95)/x111
} else {
    0.0
}).abs()/(PI*((nx).powi(2) + (ny).powi(2) + (nz).powi(2)).sqrt())
}

pub(crate) fn henyey_greenstein(g: f64, cos_theta: f64) -> f64 {
    let x0 = (g).powi(2);
    (1.0/4.0)*(1.0 - x0)/(PI*(-2.0*cos_theta*g + x0 + 1.0).powf(3.0/2.0))
}

pub(crate) fn henyey_greenstein_sample(g: f64, u: f64) -> f64 {
    let x0 = (g).powi(2);
    (1.0/2.0)*(x0 - (1.0 - x0).powi(2)/(2.0*g*u - g + 1.0).powi(2) + 1.0)/g
}

pub(crate) fn ggx_visible_pdf(alpha: f64, wx: f64, wy: f64, wz: f64, x: f64, y: f64, z: f64) -> f64 {
    let x0 = (alpha).powi(2);
    let x1 = (x0).powi(-1);
    let x2 = wx*x + wy*y + wz*z;
    2.0*x1*if (x2 > 0.0) {
    x2
} else {
    0.0
}/(PI*wz*(x1*((x).powi(2) + (y).powi(2)) + (z).powi(2)).powi(2)*((1.0 + x0*((wx).powi(2) + (wy).powi(2))/(wz).powi(2)).sqrt() + 1.0))
}

pub(crate) fn transmittance_with_emission(L0: f64, sigma: f64, t: f64, j: f64) -> f64 {
    let x0 = (-sigma*t).exp();
    L0*x0 + j*(1.0 - x0)/sigma
}

pub(crate) fn form_factor_integrand(x0: f64, x1: f64, x2: f64, n0: f64, n1: f64, n2: f64, y0: f64, y1: f64, y2: f64, m0: f64, m1: f64, m2: f64) -> f64 {
    let x3 = -x0 + y0;
    let x4 = -x1 + y1;
    let x5 = -x2 + y2;
    (-m0*x3 - m1*x4 - m2*x5)*(n0*x3 + n1*x4 + n2*x5)/(PI*((x3).powi(2) + (x4).powi(2) + (x5).powi(2)).powi(2))
}
