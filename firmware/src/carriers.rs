//! Carriers of a world on the chip: only the types that occur in its scene.
//!
//! In: modules of derived equations. Out: [`derived!`], a carrier of such equations with the ports in use, and
//! [`carriers!`], one enum for all carriers of a scene, so that a group of them is a list. No call goes through a
//! pointer.

/// Defines a carrier of the equations in `$module`. Each port is given by its answer function and the index of its
/// wrench, six numbers, among the inputs; the module's `command` gives the inputs by the model's control law.
macro_rules! derived {
    ($name:ident: $module:ident::$equations:ident, ports: [$($function:ident => $first:literal),*]) => {
        /// Derived equations with their last inputs, and the position of their origin (m).
        pub struct $name {
            equations: $module::$equations,
            inputs: [f32; $module::N_INPUTS],
            place: Vec3<f32>,
        }

        impl $name {
            /// At this position, with all inputs 0.
            pub fn at(place: Vec3<f32>) -> Self {
                Self { equations: $module::$equations::default(), inputs: [0.0; $module::N_INPUTS], place }
            }
        }

        #[allow(unused_mut, unused_variables, reason = "a scene may use none of its ports")]
        impl Carrier<f32> for $name {
            fn n_q(&self) -> usize {
                $module::NQ
            }
            fn n_u(&self) -> usize {
                $module::NU
            }
            fn n_ports(&self) -> usize {
                const FIRST: &[usize] = &[$($first),*];
                FIRST.len()
            }
            fn coupled(&self, _: usize) -> core::ops::Range<usize> {
                if $module::NU == 0 { 0..0 } else { 0..self.n_ports() }
            }
            fn inverse_inertia(
                &mut self,
                t: f32,
                q: &[f32],
                u: &[f32],
                [seen, at]: [usize; 2],
            ) -> Result<InverseInertia<f32>, Fault> {
                let (Ok(own_q), Ok(own_u)) =
                    (<&[f32; $module::NQ]>::try_from(q), <&[f32; $module::NU]>::try_from(u))
                else {
                    return Err(Fault::Shape);
                };
                const FIRST: &[usize] = &[$($first),*];
                let (mut number, mut found) =
                    (0, None::<(InverseInertia<f32>, [[f32; $module::NU]; 6])>);
                $(
                    if number == seen {
                        let port = $module::$function(t, own_q, own_u, &self.inputs, self.equations.prepared());
                        found = Some((port.inverse_inertia, port.jacobian));
                    }
                    number += 1;
                )*
                let _ = number;
                let (own, jacobian) = found.ok_or(Fault::Shape)?;
                if seen == at {
                    return Ok(own);
                }
                // J of one port times the change of u' by a unit wrench at the other.
                let mut free = [0.0; $module::NU];
                let mut changes = [[0.0; $module::NU]; 6];
                let wrenches = [Wrench::zero(); FIRST.len()];
                self.rates(t, q, u, &wrenches, &mut [0.0; $module::NQ], &mut free)?;
                for (direction, change) in changes.iter_mut().enumerate() {
                    let mut wrenches = wrenches;
                    if let Some(wrench) = wrenches.get_mut(at) {
                        let parts = wrench.force.iter_mut().chain(&mut wrench.moment);
                        parts.skip(direction).take(1).for_each(|part| *part = 1.0);
                    }
                    self.rates(t, q, u, &wrenches, &mut [0.0; $module::NQ], change)?;
                    change.iter_mut().zip(&free).for_each(|(to, free)| *to -= free);
                }
                Ok(jacobian.map(|row| {
                    changes.map(|change| row.iter().zip(&change).map(|(entry, u_dot)| entry * u_dot).sum::<f32>())
                }))
            }
            fn frames(&mut self, t: f32, q: &[f32], u: &[f32], frames: &mut [Frame<f32>]) -> Result<(), Fault> {
                let (Ok(q), Ok(u)) =
                    (<&[f32; $module::NQ]>::try_from(q), <&[f32; $module::NU]>::try_from(u))
                else {
                    return Err(Fault::Shape);
                };
                let mut frames = frames.iter_mut();
                $(
                    let port = $module::$function(t, q, u, &self.inputs, self.equations.prepared());
                    let [a, b, c] = port.rotation;
                    let [vx, vy, vz, wx, wy, wz] = port.twist;
                    *frames.next().ok_or(Fault::Shape)? = Frame {
                        origin: vec3::add(port.position, self.place),
                        axes: [[a[0], b[0], c[0]], [a[1], b[1], c[1]], [a[2], b[2], c[2]]],
                        velocity: [vx, vy, vz],
                        angular_velocity: [wx, wy, wz],
                    };
                )*
                Ok(())
            }
            fn rates(
                &mut self,
                t: f32,
                q: &[f32],
                u: &[f32],
                wrenches: &[Wrench<f32>],
                q_dot: &mut [f32],
                u_dot: &mut [f32],
            ) -> Result<f32, Fault> {
                let (Ok(own_q), Ok(own_u)) =
                    (<&[f32; $module::NQ]>::try_from(q), <&[f32; $module::NU]>::try_from(u))
                else {
                    return Err(Fault::Shape);
                };
                self.inputs = $module::command(t, own_q, own_u, &self.inputs, self.equations.prepared());
                for (first, wrench) in [$($first),*].into_iter().zip(wrenches) {
                    let first: usize = first;
                    let own = self.inputs.iter_mut().skip(first);
                    own.zip(wrench.force.iter().chain(&wrench.moment)).for_each(|(to, from)| *to = *from);
                }
                self.equations.rates(t, q, u, &self.inputs, q_dot, u_dot)
            }
            fn energy(&mut self, _: f32, q: &[f32], u: &[f32]) -> Result<(f32, f32), Fault> {
                self.equations.energy(q, u)
            }
            fn project(&mut self, q: &mut [f32]) -> Result<f32, Fault> {
                self.equations.project(q)
            }
            fn set_time(&mut self, t: f32) {
                self.equations.set_time(t);
            }
            fn projections(&self) -> u8 {
                u8::from(!$module::CORRECTED.is_empty())
            }
        }
    };
}

/// Defines one enum for carriers of several types: each variant of `$name` holds one.
macro_rules! carriers {
    ($name:ident { $($variant:ident: $type:ty),* }) => {
        /// A carrier of this scene.
        pub enum $name {
            $(
                /// A carrier of one of the types.
                $variant($type),
            )*
        }

        impl Carrier<f32> for $name {
            fn n_q(&self) -> usize {
                match self { $(Self::$variant(own) => own.n_q(),)* }
            }
            fn n_u(&self) -> usize {
                match self { $(Self::$variant(own) => own.n_u(),)* }
            }
            fn n_ports(&self) -> usize {
                match self { $(Self::$variant(own) => own.n_ports(),)* }
            }
            fn coupled(&self, port: usize) -> core::ops::Range<usize> {
                match self { $(Self::$variant(own) => own.coupled(port),)* }
            }
            fn inverse_inertia(
                &mut self,
                t: f32,
                q: &[f32],
                u: &[f32],
                ports: [usize; 2],
            ) -> Result<InverseInertia<f32>, Fault> {
                match self { $(Self::$variant(own) => own.inverse_inertia(t, q, u, ports),)* }
            }
            fn frames(&mut self, t: f32, q: &[f32], u: &[f32], frames: &mut [Frame<f32>]) -> Result<(), Fault> {
                match self { $(Self::$variant(own) => own.frames(t, q, u, frames),)* }
            }
            fn rates(
                &mut self,
                t: f32,
                q: &[f32],
                u: &[f32],
                wrenches: &[Wrench<f32>],
                q_dot: &mut [f32],
                u_dot: &mut [f32],
            ) -> Result<f32, Fault> {
                match self { $(Self::$variant(own) => own.rates(t, q, u, wrenches, q_dot, u_dot),)* }
            }
            fn energy(&mut self, t: f32, q: &[f32], u: &[f32]) -> Result<(f32, f32), Fault> {
                match self { $(Self::$variant(own) => own.energy(t, q, u),)* }
            }
            fn project(&mut self, q: &mut [f32]) -> Result<f32, Fault> {
                match self { $(Self::$variant(own) => own.project(q),)* }
            }
            fn set_time(&mut self, t: f32) {
                match self { $(Self::$variant(own) => own.set_time(t),)* }
            }
            fn projections(&self) -> u8 {
                match self { $(Self::$variant(own) => own.projections(),)* }
            }
        }
    };
}
