//! The bed's numbers against closed forms, hand-made maps and independent references.

mod band;
mod beside;
mod clocks;
mod cover;
mod draw;
mod dynamics;
mod empty;
mod figure;
mod files;
mod impact;
mod laying;
mod mesh;
mod metrics;
mod plan;
mod policy;
mod published;
mod readings;
mod rest;
mod rub;
mod sensor;
mod sheet;
mod soft;
mod states;
