//! Written by `generate.py` with wrenfold 0.5.3.

#[inline]
#[allow(non_snake_case, clippy::too_many_arguments, clippy::unused_unit, clippy::collapsible_else_if, clippy::needless_late_init, clippy::neg_multiply, unused_variables, unused_parens)]
pub fn solid_angle_density_patch<>(u: f64, v: f64, ax: f64, ay: f64, az: f64, bx: f64, by: f64, bz: f64, cx: f64, cy: f64, cz: f64, dx: f64, dy: f64, dz: f64) -> f64
{
  // Operation counts:
  // add: 36
  // call: 1
  // divide: 1
  // multiply: 45
  // negate: 14
  // total: 97
  
  let v0003: f64 = u;
  let v0047: f64 = dz;
  let v0045: f64 = cz;
  let v0007: f64 = (1i64) as f64 + -v0003;
  let v0043: f64 = bz;
  let v0041: f64 = az;
  let v0017: f64 = v;
  let v0025: f64 = dy;
  let v0021: f64 = cy;
  let v0023: f64 = by;
  let v0016: f64 = ay;
  let v0013: f64 = dx;
  let v0011: f64 = cx;
  let v0009: f64 = bx;
  let v0001: f64 = ax;
  let v0169: f64 = -v0041;
  let v0163: f64 = -v0016;
  let v0161: f64 = -v0001;
  let v0019: f64 = (1i64) as f64 + -v0017;
  let v0126: f64 = v0019 * (v0007 * v0041 + v0003 * v0043) + v0017 * (v0007 * v0045 + v0003 * v0047);
  let v0149: f64 = v0019 * (v0007 * v0016 + v0003 * v0023) + v0017 * (v0007 * v0021 + v0003 * v0025);
  let v0158: f64 = v0019 * (v0001 * v0007 + v0003 * v0009) + v0017 * (v0007 * v0011 + v0003 * v0013);
  let v0140: f64 = v0019 * (v0043 + v0169) + v0017 * (v0047 + -v0045);
  let v0117: f64 = v0007 * (v0021 + v0163) + v0003 * (v0025 + -v0023);
  let v0133: f64 = v0007 * (v0045 + v0169) + v0003 * (v0047 + -v0043);
  let v0110: f64 = v0019 * (v0009 + v0161) + v0017 * (v0013 + -v0011);
  let v0103: f64 = v0019 * (v0023 + v0163) + v0017 * (v0025 + -v0021);
  let v0096: f64 = v0007 * (v0011 + v0161) + v0003 * (v0013 + -v0009);
  let v0084: f64 = (v0158 * v0158 + v0149 * v0149 + v0126 * v0126).sqrt();
  ((v0110 * v0117 + -(v0096 * v0103)) * v0126 + (v0096 * v0140 + -(v0110 * v0133)) * v0149 + (v0103 * v0133 + -(v0117 * v0140)) * v0158) * ((1i64) as f64 / (v0084 * v0084 * v0084))
}
#[inline]
#[allow(non_snake_case, clippy::too_many_arguments, clippy::unused_unit, clippy::collapsible_else_if, clippy::needless_late_init, clippy::neg_multiply, unused_variables, unused_parens)]
pub fn solid_angle_triangle<>(px: f64, py: f64, pz: f64, ax: f64, ay: f64, az: f64, bx: f64, by: f64, bz: f64, cx: f64, cy: f64, cz: f64) -> f64
{
  // Operation counts:
  // add: 29
  // call: 4
  // multiply: 32
  // negate: 6
  // total: 71
  
  let v008: f64 = pz;
  let v012: f64 = py;
  let v003: f64 = px;
  let v084: f64 = -v008;
  let v007: f64 = bz;
  let v085: f64 = -v012;
  let v016: f64 = by;
  let v083: f64 = -v003;
  let v025: f64 = bx;
  let v018: f64 = cz;
  let v011: f64 = cy;
  let v028: f64 = cx;
  let v010: f64 = v007 + v084;
  let v017: f64 = v016 + v085;
  let v026: f64 = v025 + v083;
  let v019: f64 = v018 + v084;
  let v014: f64 = v011 + v085;
  let v029: f64 = v028 + v083;
  let v033: f64 = az;
  let v023: f64 = ay;
  let v001: f64 = ax;
  let v034: f64 = v033 + v084;
  let v024: f64 = v023 + v085;
  let v006: f64 = v001 + v083;
  let v058: f64 = (v026 * v026 + v017 * v017 + v010 * v010).sqrt();
  let v048: f64 = (v029 * v029 + v014 * v014 + v019 * v019).sqrt();
  (v006 * (v017 * v019 + -(v010 * v014)) + v024 * (v010 * v029 + -(v019 * v026)) + v034 * (v014 * v026 + -(v017 * v029))).atan2((v006 * v026 + v017 * v024 + v010 * v034) * v048 + (v006 * v029 + v014 * v024 + v019 * v034) * v058 + (v006 * v006 + v024 * v024 + v034 * v034).sqrt() * ((v026 * v029 + v014 * v017 + v010 * v019) + v048 * v058)) * (2i64) as f64
}
#[inline]
#[allow(non_snake_case, clippy::too_many_arguments, clippy::unused_unit, clippy::collapsible_else_if, clippy::needless_late_init, clippy::neg_multiply, unused_variables, unused_parens)]
pub fn form_factor_point_rectangle<>(px: f64, py: f64, pz: f64, nx: f64, ny: f64, nz: f64, ox: f64, oy: f64, oz: f64, ux: f64, uy: f64, uz: f64, vx: f64, vy: f64, vz: f64) -> f64
{
  // Operation counts:
  // add: 83
  // branch: 21
  // call: 16
  // compare: 9
  // divide: 7
  // multiply: 127
  // negate: 18
  // total: 281
  
  let v0034: f64 = pz;
  let v0027: f64 = py;
  let v0019: f64 = px;
  let v0031: f64 = oz;
  let v0024: f64 = oy;
  let v0015: f64 = ox;
  let v0326: f64 = v0031 + -v0034;
  let v0032: f64 = uz;
  let v0325: f64 = v0024 + -v0027;
  let v0025: f64 = uy;
  let v0324: f64 = v0015 + -v0019;
  let v0016: f64 = ux;
  let v0343: f64 = v0032 + v0326;
  let v0033: f64 = vz;
  let v0341: f64 = v0025 + v0325;
  let v0026: f64 = vy;
  let v0339: f64 = v0016 + v0324;
  let v0017: f64 = vx;
  let v0036: f64 = v0033 + v0343;
  let v0009: f64 = nz;
  let v0029: f64 = v0026 + v0341;
  let v0007: f64 = ny;
  let v0022: f64 = v0017 + v0339;
  let v0005: f64 = nx;
  let v0344: f64 = v0033 + v0326;
  let v0342: f64 = v0026 + v0325;
  let v0340: f64 = v0017 + v0324;
  let v0038: f64 = v0005 * v0022 + v0007 * v0029 + v0009 * v0036;
  let v0047: f64 = v0005 * v0340 + v0007 * v0342 + v0009 * v0344;
  let v0050: f64 = (v0038).abs();
  let v0048: f64 = (v0047).abs();
  let v0052: f64 = v0022 * v0048 + v0050 * v0340;
  let v0057: f64 = v0036 * v0048 + v0050 * v0344;
  let v0067: f64 = v0029 * v0048 + v0050 * v0342;
  let v0040: bool = ((0i64) as f64) < (v0038);
  let v0053: f64;
  let v0060: f64;
  let v0068: f64;
  if v0040 {
    v0053 = v0022;
    v0060 = v0036;
    v0068 = v0029;
  } else {
    v0053 = v0052;
    v0060 = v0057;
    v0068 = v0067;
  }
  let v0054: bool = ((0i64) as f64) < (v0047);
  let v0058: f64;
  let v0061: f64;
  let v0070: f64;
  if v0054 {
    v0058 = v0344;
    v0061 = v0340;
    v0070 = v0342;
  } else {
    v0058 = v0057;
    v0061 = v0052;
    v0070 = v0067;
  }
  let v0076: f64 = v0058 * v0068 + -(v0060 * v0070);
  let v0072: f64 = v0053 * v0070 + -(v0061 * v0068);
  let v0063: f64 = v0060 * v0061 + -(v0053 * v0058);
  let v0079: f64 = (v0063 * v0063 + v0072 * v0072 + v0076 * v0076).sqrt();
  let v0092: f64;
  if ((0i64) as f64) < (v0079) {
    v0092 = (v0005 * v0076 + v0007 * v0063 + v0009 * v0072) * ((1i64) as f64 / v0079) * (v0079).atan2(v0053 * v0061 + v0068 * v0070 + v0058 * v0060);
  } else {
    v0092 = (0i64) as f64;
  }
  let v0101: f64 = v0005 * v0339 + v0007 * v0341 + v0009 * v0343;
  let v0103: f64 = (v0101).abs();
  let v0106: f64 = v0022 * v0103 + v0050 * v0339;
  let v0110: f64 = v0029 * v0103 + v0050 * v0341;
  let v0120: f64 = v0036 * v0103 + v0050 * v0343;
  let v0107: f64;
  let v0113: f64;
  let v0123: f64;
  if v0040 {
    v0107 = v0022;
    v0113 = v0029;
    v0123 = v0036;
  } else {
    v0107 = v0106;
    v0113 = v0110;
    v0123 = v0120;
  }
  let v0102: bool = ((0i64) as f64) < (v0101);
  let v0111: f64;
  let v0114: f64;
  let v0121: f64;
  if v0102 {
    v0111 = v0341;
    v0114 = v0339;
    v0121 = v0343;
  } else {
    v0111 = v0110;
    v0114 = v0106;
    v0121 = v0120;
  }
  let v0129: f64 = v0107 * v0121 + -(v0114 * v0123);
  let v0125: f64 = v0111 * v0123 + -(v0113 * v0121);
  let v0116: f64 = v0113 * v0114 + -(v0107 * v0111);
  let v0132: f64 = (v0116 * v0116 + v0125 * v0125 + v0129 * v0129).sqrt();
  let v0145: f64;
  if ((0i64) as f64) < (v0132) {
    v0145 = (v0005 * v0125 + v0007 * v0129 + v0009 * v0116) * ((1i64) as f64 / v0132) * (v0132).atan2(v0107 * v0114 + v0111 * v0113 + v0121 * v0123);
  } else {
    v0145 = (0i64) as f64;
  }
  let v0154: f64 = v0005 * v0324 + v0007 * v0325 + v0009 * v0326;
  let v0155: f64 = (v0154).abs();
  let v0158: f64 = v0155 * v0340 + v0048 * v0324;
  let v0163: f64 = v0155 * v0344 + v0048 * v0326;
  let v0173: f64 = v0155 * v0342 + v0048 * v0325;
  let v0159: f64;
  let v0166: f64;
  let v0174: f64;
  if v0054 {
    v0159 = v0340;
    v0166 = v0344;
    v0174 = v0342;
  } else {
    v0159 = v0158;
    v0166 = v0163;
    v0174 = v0173;
  }
  let v0160: bool = ((0i64) as f64) < (v0154);
  let v0164: f64;
  let v0167: f64;
  let v0176: f64;
  if v0160 {
    v0164 = v0326;
    v0167 = v0324;
    v0176 = v0325;
  } else {
    v0164 = v0163;
    v0167 = v0158;
    v0176 = v0173;
  }
  let v0182: f64 = v0164 * v0174 + -(v0166 * v0176);
  let v0178: f64 = v0159 * v0176 + -(v0167 * v0174);
  let v0169: f64 = v0166 * v0167 + -(v0159 * v0164);
  let v0185: f64 = (v0169 * v0169 + v0178 * v0178 + v0182 * v0182).sqrt();
  let v0198: f64;
  if ((0i64) as f64) < (v0185) {
    v0198 = (v0005 * v0182 + v0007 * v0169 + v0009 * v0178) * ((1i64) as f64 / v0185) * (v0185).atan2(v0159 * v0167 + v0174 * v0176 + v0164 * v0166);
  } else {
    v0198 = (0i64) as f64;
  }
  let v0203: f64 = v0155 * v0339 + v0103 * v0324;
  let v0207: f64 = v0155 * v0341 + v0103 * v0325;
  let v0217: f64 = v0155 * v0343 + v0103 * v0326;
  let v0204: f64;
  let v0210: f64;
  let v0220: f64;
  if v0102 {
    v0204 = v0339;
    v0210 = v0341;
    v0220 = v0343;
  } else {
    v0204 = v0203;
    v0210 = v0207;
    v0220 = v0217;
  }
  let v0208: f64;
  let v0211: f64;
  let v0218: f64;
  if v0160 {
    v0208 = v0325;
    v0211 = v0324;
    v0218 = v0326;
  } else {
    v0208 = v0207;
    v0211 = v0203;
    v0218 = v0217;
  }
  let v0226: f64 = v0204 * v0218 + -(v0211 * v0220);
  let v0222: f64 = v0208 * v0220 + -(v0210 * v0218);
  let v0213: f64 = v0210 * v0211 + -(v0204 * v0208);
  let v0229: f64 = (v0213 * v0213 + v0222 * v0222 + v0226 * v0226).sqrt();
  let v0242: f64;
  if ((0i64) as f64) < (v0229) {
    v0242 = (v0005 * v0222 + v0007 * v0226 + v0009 * v0213) * ((1i64) as f64 / v0229) * (v0229).atan2(v0204 * v0211 + v0208 * v0210 + v0218 * v0220);
  } else {
    v0242 = (0i64) as f64;
  }
  let v0244: f64;
  let v0246: f64;
  let v0254: f64;
  let v0263: f64;
  let v0271: f64;
  let v0282: f64;
  let v0291: f64;
  if v0160 {
    if v0102 {
      v0254 = (0i64) as f64;
      v0271 = (0i64) as f64;
      v0282 = (0i64) as f64;
    } else {
      v0254 = v0207;
      v0271 = v0203;
      v0282 = v0217;
    }
    v0244 = v0242;
    v0246 = (0i64) as f64;
    v0263 = (0i64) as f64;
    v0291 = (0i64) as f64;
  } else {
    if v0102 {
      v0244 = v0242;
      v0246 = v0203;
      v0263 = v0207;
      v0291 = v0217;
    } else {
      v0244 = (0i64) as f64;
      v0246 = (0i64) as f64;
      v0263 = (0i64) as f64;
      v0291 = (0i64) as f64;
    }
    v0254 = (0i64) as f64;
    v0271 = (0i64) as f64;
    v0282 = (0i64) as f64;
  }
  let v0147: f64;
  let v0248: f64;
  let v0256: f64;
  let v0265: f64;
  let v0273: f64;
  let v0284: f64;
  let v0293: f64;
  if v0102 {
    if v0040 {
      v0256 = v0254;
      v0273 = v0271;
      v0284 = v0282;
    } else {
      v0256 = v0110;
      v0273 = v0106;
      v0284 = v0120;
    }
    v0147 = v0145;
    v0248 = v0246;
    v0265 = v0263;
    v0293 = v0291;
  } else {
    if v0040 {
      v0147 = v0145;
      v0248 = v0106;
      v0265 = v0110;
      v0293 = v0120;
    } else {
      v0147 = (0i64) as f64;
      v0248 = v0246;
      v0265 = v0263;
      v0293 = v0291;
    }
    v0256 = v0254;
    v0273 = v0271;
    v0284 = v0282;
  }
  let v0094: f64;
  let v0250: f64;
  let v0258: f64;
  let v0267: f64;
  let v0275: f64;
  let v0286: f64;
  let v0295: f64;
  if v0040 {
    if v0054 {
      v0258 = v0256;
      v0275 = v0273;
      v0286 = v0284;
    } else {
      v0258 = v0067;
      v0275 = v0052;
      v0286 = v0057;
    }
    v0094 = v0092;
    v0250 = v0248;
    v0267 = v0265;
    v0295 = v0293;
  } else {
    if v0054 {
      v0094 = v0092;
      v0250 = v0052;
      v0267 = v0067;
      v0295 = v0057;
    } else {
      v0094 = (0i64) as f64;
      v0250 = v0248;
      v0267 = v0265;
      v0295 = v0293;
    }
    v0258 = v0256;
    v0275 = v0273;
    v0286 = v0284;
  }
  let v0200: f64;
  let v0252: f64;
  let v0260: f64;
  let v0269: f64;
  let v0277: f64;
  let v0288: f64;
  let v0297: f64;
  if v0054 {
    if v0160 {
      v0260 = v0258;
      v0277 = v0275;
      v0288 = v0286;
    } else {
      v0260 = v0173;
      v0277 = v0158;
      v0288 = v0163;
    }
    v0200 = v0198;
    v0252 = v0250;
    v0269 = v0267;
    v0297 = v0295;
  } else {
    if v0160 {
      v0200 = v0198;
      v0252 = v0158;
      v0269 = v0173;
      v0297 = v0163;
    } else {
      v0200 = (0i64) as f64;
      v0252 = v0250;
      v0269 = v0267;
      v0297 = v0295;
    }
    v0260 = v0258;
    v0277 = v0275;
    v0288 = v0286;
  }
  let v0303: f64 = v0252 * v0288 + -(v0277 * v0297);
  let v0299: f64 = v0260 * v0297 + -(v0269 * v0288);
  let v0279: f64 = v0269 * v0277 + -(v0252 * v0260);
  let v0306: f64 = (v0279 * v0279 + v0299 * v0299 + v0303 * v0303).sqrt();
  let v0319: f64;
  if ((0i64) as f64) < (v0306) {
    v0319 = (v0005 * v0299 + v0007 * v0303 + v0009 * v0279) * ((1i64) as f64 / v0306) * (v0306).atan2(v0252 * v0277 + v0260 * v0269 + v0288 * v0297);
  } else {
    v0319 = (0i64) as f64;
  }
  0.5f64 * ((1i64) as f64 / std::f64::consts::PI) * ((1i64) as f64 / (v0005 * v0005 + v0007 * v0007 + v0009 * v0009).sqrt()) * (v0094 + v0147 + v0200 + v0244 + v0319).abs()
}
#[inline]
#[allow(non_snake_case, clippy::unused_unit, clippy::collapsible_else_if, clippy::needless_late_init, clippy::neg_multiply, unused_variables, unused_parens)]
pub fn henyey_greenstein<>(g: f64, cos_theta: f64) -> f64
{
  // Operation counts:
  // add: 3
  // call: 1
  // divide: 2
  // multiply: 8
  // negate: 2
  // total: 16
  
  let v011: f64 = cos_theta;
  let v003: f64 = g;
  let v016: f64 = ((1i64) as f64 + v003 * (v003 + -(v011 * (2i64) as f64))).sqrt();
  0.25f64 * ((1i64) as f64 + -(v003 * v003)) * ((1i64) as f64 / std::f64::consts::PI) * ((1i64) as f64 / (v016 * v016 * v016))
}
#[inline]
#[allow(non_snake_case, clippy::unused_unit, clippy::collapsible_else_if, clippy::needless_late_init, clippy::neg_multiply, unused_variables, unused_parens)]
pub fn henyey_greenstein_sample<>(g: f64, u: f64) -> f64
{
  // Operation counts:
  // add: 5
  // divide: 2
  // multiply: 8
  // negate: 2
  // total: 17
  
  let v007: f64 = u;
  let v003: f64 = g;
  let v026: f64 = v003 * v003;
  let v025: f64 = (1i64) as f64 + v003 * ((-1i64) as f64 + v007 * (2i64) as f64);
  let v015: f64 = (1i64) as f64 + -v026;
  0.5f64 * ((1i64) as f64 + v026 + -(((1i64) as f64 / (v025 * v025)) * v015 * v015)) * ((1i64) as f64 / v003)
}
#[inline]
#[allow(non_snake_case, clippy::too_many_arguments, clippy::unused_unit, clippy::collapsible_else_if, clippy::needless_late_init, clippy::neg_multiply, unused_variables, unused_parens)]
pub fn ggx_visible_pdf<>(alpha: f64, wx: f64, wy: f64, wz: f64, x: f64, y: f64, z: f64) -> f64
{
  // Operation counts:
  // add: 7
  // branch: 1
  // call: 1
  // compare: 1
  // divide: 6
  // multiply: 20
  // total: 36
  
  let v028: f64 = z;
  let v008: f64 = wz;
  let v024: f64 = y;
  let v012: f64 = wy;
  let v022: f64 = x;
  let v010: f64 = wx;
  let v037: f64 = v010 * v022 + v012 * v024 + v008 * v028;
  let v040: f64;
  if ((0i64) as f64) < (v037) {
    v040 = v037;
  } else {
    v040 = (0i64) as f64;
  }
  let v005: f64 = alpha;
  let v044: f64 = v005 * v005;
  let v007: f64 = (1i64) as f64 / v044;
  let v030: f64 = v007 * (v022 * v022 + v024 * v024) + v028 * v028;
  ((1i64) as f64 / std::f64::consts::PI) * v007 * ((1i64) as f64 / v008) * ((1i64) as f64 / ((1i64) as f64 + ((1i64) as f64 + (v010 * v010 + v012 * v012) * ((1i64) as f64 / (v008 * v008)) * v044).sqrt())) * ((1i64) as f64 / (v030 * v030)) * v040 * (2i64) as f64
}
#[inline]
#[allow(non_snake_case, clippy::unused_unit, clippy::collapsible_else_if, clippy::needless_late_init, clippy::neg_multiply, unused_variables, unused_parens)]
pub fn transmittance_with_emission<>(L0: f64, sigma: f64, t: f64, j: f64) -> f64
{
  // Operation counts:
  // add: 2
  // call: 1
  // divide: 1
  // multiply: 4
  // negate: 2
  // total: 10
  
  let v003: f64 = t;
  let v002: f64 = sigma;
  let v006: f64 = (-(v002 * v003)).exp();
  let v008: f64 = j;
  let v000: f64 = L0;
  v000 * v006 + v008 * ((1i64) as f64 + -v006) * ((1i64) as f64 / v002)
}
#[inline]
#[allow(non_snake_case, clippy::too_many_arguments, clippy::unused_unit, clippy::collapsible_else_if, clippy::needless_late_init, clippy::neg_multiply, unused_variables, unused_parens)]
pub fn form_factor_integrand<>(x0: f64, x1: f64, x2: f64, n0: f64, n1: f64, n2: f64, y0: f64, y1: f64, y2: f64, m0: f64, m1: f64, m2: f64) -> f64
{
  // Operation counts:
  // add: 9
  // divide: 2
  // multiply: 13
  // negate: 4
  // total: 28
  
  let v016: f64 = x2;
  let v010: f64 = x1;
  let v003: f64 = x0;
  let v015: f64 = y2;
  let v009: f64 = y1;
  let v002: f64 = y0;
  let v018: f64 = v015 + -v016;
  let v012: f64 = v009 + -v010;
  let v006: f64 = v002 + -v003;
  let v014: f64 = m2;
  let v008: f64 = m1;
  let v001: f64 = m0;
  let v035: f64 = v006 * v006 + v012 * v012 + v018 * v018;
  let v025: f64 = n2;
  let v023: f64 = n1;
  let v021: f64 = n0;
  -((v006 * v021 + v012 * v023 + v018 * v025) * ((1i64) as f64 / std::f64::consts::PI) * ((1i64) as f64 / (v035 * v035)) * (v001 * v006 + v008 * v012 + v014 * v018))
}