//! Units: rational exponents of kg, m, s, K, A, and a factor to SI.
//!
//! rad has no dimension. A unit text is a product of names with powers: `kg m^2`, `N s/m`,
//! `m/s^2`, `m^(1/2)`. At most one `/`, or a parenthesis after it: `kg/(m s)`.

use std::fmt;

/// A rational number with a positive denominator, reduced.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Ratio {
    numerator: i8,
    denominator: i8,
}

impl Ratio {
    /// Zero.
    pub const ZERO: Self = Self { numerator: 0, denominator: 1 };

    /// n/d, reduced; none if d = 0 or the numbers grow beyond 8 bits.
    #[must_use]
    pub fn new(n: i32, d: i32) -> Option<Self> {
        let (mut a, mut b) = (n.unsigned_abs(), d.unsigned_abs());
        while b != 0 {
            (a, b) = (b, a % b);
        }
        let divisor = i32::try_from(a).ok().filter(|_| d != 0)? * d.signum();
        let divisor = if divisor == 0 { d } else { divisor };
        Some(Self {
            numerator: i8::try_from(n / divisor).ok()?,
            denominator: i8::try_from(d / divisor).ok()?,
        })
    }

    fn plus(self, other: Self) -> Option<Self> {
        let (a, b) = (i32::from(self.numerator), i32::from(self.denominator));
        let (c, d) = (i32::from(other.numerator), i32::from(other.denominator));
        Self::new(a.checked_mul(d)?.checked_add(c.checked_mul(b)?)?, b.checked_mul(d)?)
    }

    fn times(self, n: i32, d: i32) -> Option<Self> {
        Self::new(i32::from(self.numerator).checked_mul(n)?, i32::from(self.denominator).checked_mul(d)?)
    }
}

/// A dimension: exponents of kg, m, s, K, A.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Unit {
    exponents: [Ratio; 5],
}

impl Default for Unit {
    fn default() -> Self {
        Self::NONE
    }
}

/// Names of the base units.
const BASE: [&str; 5] = ["kg", "m", "s", "K", "A"];

impl Unit {
    /// No dimension: numbers and angles.
    pub const NONE: Self = Self { exponents: [Ratio::ZERO; 5] };
    /// m.
    pub const LENGTH: Self = Self::integers([0, 1, 0, 0, 0]);
    /// s.
    pub const TIME: Self = Self::integers([0, 0, 1, 0, 0]);
    /// kg.
    pub const MASS: Self = Self::integers([1, 0, 0, 0, 0]);
    /// m/s.
    pub const VELOCITY: Self = Self::integers([0, 1, -1, 0, 0]);
    /// 1/s.
    pub const RATE: Self = Self::integers([0, 0, -1, 0, 0]);
    /// m/s^2.
    pub const ACCELERATION: Self = Self::integers([0, 1, -2, 0, 0]);
    /// kg m^2.
    pub const INERTIA: Self = Self::integers([1, 2, 0, 0, 0]);
    /// N.
    pub const FORCE: Self = Self::integers([1, 1, -2, 0, 0]);
    /// N m.
    pub const TORQUE: Self = Self::integers([1, 2, -2, 0, 0]);

    const fn integers(of: [i8; 5]) -> Self {
        let mut exponents = [Ratio::ZERO; 5];
        let mut i = 0;
        while i < 5 {
            exponents[i] = Ratio { numerator: of[i], denominator: 1 };
            i += 1;
        }
        Self { exponents }
    }

    fn combine(self, other: Self, sign: i32) -> Option<Self> {
        let mut exponents = self.exponents;
        for (e, o) in exponents.iter_mut().zip(other.exponents) {
            *e = e.plus(o.times(sign, 1)?)?;
        }
        Some(Self { exponents })
    }

    /// Unit of a product; `None` if an exponent becomes too large.
    #[must_use]
    pub fn times(self, other: Self) -> Option<Self> {
        self.combine(other, 1)
    }

    /// Unit of a quotient.
    #[must_use]
    pub fn per(self, other: Self) -> Option<Self> {
        self.combine(other, -1)
    }

    /// Unit of a power with the exponent n/d.
    #[must_use]
    pub fn power(self, n: i32, d: i32) -> Option<Self> {
        let mut exponents = self.exponents;
        for e in &mut exponents {
            *e = e.times(n, d)?;
        }
        Some(Self { exponents })
    }
}

/// Units that have a name of their own in messages.
const NAMED: [(&str, Unit); 6] = [
    ("N", Unit::FORCE),
    ("Pa", Unit::integers([1, -1, -2, 0, 0])),
    ("N m", Unit::TORQUE),
    ("W", Unit::integers([1, 2, -3, 0, 0])),
    ("N/m", Unit::integers([1, 0, -2, 0, 0])),
    ("N s/m", Unit::integers([1, 0, -1, 0, 0])),
];

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some((name, _)) = NAMED.iter().find(|(_, unit)| unit == self) {
            return f.write_str(name);
        }
        let factor = |name: &str, n: i8, d: i8| match (n, d) {
            (1, 1) => name.to_owned(),
            (n, 1) => format!("{name}^{n}"),
            (n, d) => format!("{name}^({n}/{d})"),
        };
        let (mut above, mut below) = (Vec::new(), Vec::new());
        for (name, e) in BASE.iter().zip(self.exponents) {
            match e.numerator {
                0 => {}
                n if 0 < n => above.push(factor(name, n, e.denominator)),
                n => below.push(factor(name, -n, e.denominator)),
            }
        }
        let above = if above.is_empty() { "1".to_owned() } else { above.join(" ") };
        match below.len() {
            0 => f.write_str(&above),
            1 => write!(f, "{above}/{}", below[0]),
            _ => write!(f, "{above}/({})", below.join(" ")),
        }
    }
}

/// A unit with its factor to SI.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Scale {
    /// Its dimension.
    pub unit: Unit,
    /// Its value in SI units.
    pub factor: f64,
}

/// Unit names: name, factor, exponents of kg m s K A.
const NAMES: &[(&str, f64, [i8; 5])] = &[
    ("1", 1.0, [0, 0, 0, 0, 0]),
    ("rad", 1.0, [0, 0, 0, 0, 0]),
    ("deg", std::f64::consts::PI / 180.0, [0, 0, 0, 0, 0]),
    ("kg", 1.0, [1, 0, 0, 0, 0]),
    ("g", 1e-3, [1, 0, 0, 0, 0]),
    ("mg", 1e-6, [1, 0, 0, 0, 0]),
    ("m", 1.0, [0, 1, 0, 0, 0]),
    ("km", 1e3, [0, 1, 0, 0, 0]),
    ("cm", 1e-2, [0, 1, 0, 0, 0]),
    ("mm", 1e-3, [0, 1, 0, 0, 0]),
    ("um", 1e-6, [0, 1, 0, 0, 0]),
    ("s", 1.0, [0, 0, 1, 0, 0]),
    ("ms", 1e-3, [0, 0, 1, 0, 0]),
    ("us", 1e-6, [0, 0, 1, 0, 0]),
    ("min", 60.0, [0, 0, 1, 0, 0]),
    ("h", 3600.0, [0, 0, 1, 0, 0]),
    ("Hz", 1.0, [0, 0, -1, 0, 0]),
    ("kHz", 1e3, [0, 0, -1, 0, 0]),
    ("N", 1.0, [1, 1, -2, 0, 0]),
    ("mN", 1e-3, [1, 1, -2, 0, 0]),
    ("kN", 1e3, [1, 1, -2, 0, 0]),
    ("J", 1.0, [1, 2, -2, 0, 0]),
    ("kJ", 1e3, [1, 2, -2, 0, 0]),
    ("W", 1.0, [1, 2, -3, 0, 0]),
    ("kW", 1e3, [1, 2, -3, 0, 0]),
    ("Pa", 1.0, [1, -1, -2, 0, 0]),
    ("kPa", 1e3, [1, -1, -2, 0, 0]),
    ("MPa", 1e6, [1, -1, -2, 0, 0]),
    ("bar", 1e5, [1, -1, -2, 0, 0]),
    // Of pressure on skin: BIPM, The International System of Units, 8th edition, table 8.
    ("mmHg", 133.322, [1, -1, -2, 0, 0]),
    ("K", 1.0, [0, 0, 0, 1, 0]),
    ("A", 1.0, [0, 0, 0, 0, 1]),
    ("mA", 1e-3, [0, 0, 0, 0, 1]),
    ("V", 1.0, [1, 2, -3, 0, -1]),
    ("C", 1.0, [0, 0, 1, 0, 1]),
    ("ohm", 1.0, [1, 2, -3, 0, -2]),
];

/// All unit names, for suggestions.
pub fn names() -> impl Iterator<Item = &'static str> {
    NAMES.iter().map(|(name, ..)| *name)
}

/// A single unit name.
#[must_use]
pub fn named(name: &str) -> Option<Scale> {
    let (_, factor, exponents) = NAMES.iter().find(|(known, ..)| *known == name)?;
    Some(Scale { unit: Unit::integers(*exponents), factor: *factor })
}

/// Reads a unit text; an empty one has no dimension.
///
/// # Errors
/// What is wrong, and the bytes it is about.
pub fn parse(text: &str) -> Result<Scale, (String, std::ops::Range<usize>)> {
    let mut reader = Reader { text, at: 0, depth: 0 };
    let scale = reader.product()?;
    match reader.at == text.len() {
        true => Ok(scale),
        false => Err((format!("unexpected `{}`", &text[reader.at..]), reader.at..text.len())),
    }
}

type Fault = (String, std::ops::Range<usize>);

/// Parentheses in a unit nest at most this deep.
const DEEPEST: usize = 8;

struct Reader<'a> {
    text: &'a str,
    at: usize,
    depth: usize,
}

impl Reader<'_> {
    fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    fn blanks(&mut self) -> bool {
        let before = self.at;
        while self.peek() == Some(b' ') {
            self.at += 1;
        }
        before < self.at
    }

    fn fault<T>(&self, start: usize, message: &str) -> Result<T, Fault> {
        Err((message.to_owned(), start..self.at.max(start)))
    }

    /// product := factor ((' ' | '*') factor)* ('/' factor)?
    fn product(&mut self) -> Result<Scale, Fault> {
        let mut result = Scale { unit: Unit::NONE, factor: 1.0 };
        let (mut divide, mut divided, mut expects) = (false, false, false);
        loop {
            self.blanks();
            match self.peek() {
                None | Some(b')') => {
                    return if expects { self.fault(self.at, "a unit is missing here") } else { Ok(result) };
                }
                Some(b'/') => {
                    if divided || expects {
                        return self.fault(self.at, "only one `/`: write kg/(m s^2)");
                    }
                    self.at += 1;
                    (divide, divided, expects) = (true, true, true);
                    continue;
                }
                Some(b'*') => {
                    self.at += 1;
                    expects = true;
                    continue;
                }
                Some(_) if divided && !divide => {
                    return self.fault(self.at, "ambiguous after `/`: write kg/(m s^2)");
                }
                Some(_) => {}
            }
            let start = self.at;
            let factor = self.factor()?;
            let unit = if divide { result.unit.per(factor.unit) } else { result.unit.times(factor.unit) };
            let Some(unit) = unit else { return self.fault(start, "exponent too large") };
            let number = if divide { result.factor / factor.factor } else { result.factor * factor.factor };
            result = Scale { unit, factor: number };
            (divide, expects) = (false, false);
        }
    }

    /// factor := (name | '(' product ')') ('^' (integer | '(' integer '/' integer ')'))?
    fn factor(&mut self) -> Result<Scale, Fault> {
        let start = self.at;
        let base = if self.peek() == Some(b'(') {
            self.depth += 1;
            if DEEPEST < self.depth {
                return self.fault(start, "too many parentheses");
            }
            self.at += 1;
            let inner = self.product()?;
            if self.peek() != Some(b')') {
                return self.fault(start, "`)` is missing");
            }
            self.at += 1;
            self.depth -= 1;
            inner
        } else {
            while self.peek().is_some_and(|c| c.is_ascii_alphanumeric()) {
                self.at += 1;
            }
            let name = &self.text[start..self.at];
            match named(name) {
                Some(scale) => scale,
                None => {
                    let rest = self.text[start..].chars().next().map_or(0, char::len_utf8);
                    let shown = if name.is_empty() { &self.text[start..start + rest] } else { name };
                    return Err((format!("unknown unit `{shown}`"), start..start + shown.len()));
                }
            }
        };
        if self.peek() != Some(b'^') {
            return Ok(base);
        }
        self.at += 1;
        let (n, d) = self.exponent()?;
        match base.unit.power(n, d) {
            Some(unit) => Ok(Scale { unit, factor: base.factor.powf(f64::from(n) / f64::from(d)) }),
            None => self.fault(start, "exponent too large"),
        }
    }

    fn exponent(&mut self) -> Result<(i32, i32), Fault> {
        if self.peek() != Some(b'(') {
            return Ok((self.integer()?, 1));
        }
        let start = self.at;
        self.at += 1;
        let n = self.integer()?;
        let mut d = 1;
        if self.peek() == Some(b'/') {
            self.at += 1;
            d = self.integer()?;
        }
        if self.peek() != Some(b')') || d == 0 {
            return self.fault(start, "expected an exponent such as 2, -1 or (1/2)");
        }
        self.at += 1;
        Ok((n, d))
    }

    fn integer(&mut self) -> Result<i32, Fault> {
        let start = self.at;
        if self.peek() == Some(b'-') {
            self.at += 1;
        }
        while self.peek().is_some_and(|c| c.is_ascii_digit()) {
            self.at += 1;
        }
        match self.text[start..self.at].parse::<i32>() {
            Ok(n) if n.abs() <= 64 => Ok(n),
            _ => self.fault(start, "expected an integer exponent of at most 64"),
        }
    }
}
