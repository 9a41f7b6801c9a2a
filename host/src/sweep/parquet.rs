//! The table of a sweep as Parquet: columns and values as in the CSV, with their origin.
//!
//! In: the table and pairs of words. Out: the bytes of a file: `case` as integers, keys of the sweep as strings,
//! metrics as nullable doubles, the pairs as the file's metadata. Only with the feature `parquet`.

use super::case::Table;
use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;
use std::sync::Arc;

/// The file's bytes.
///
/// # Errors
/// An error of the format's library.
pub fn bytes(table: &Table, pairs: &[(&str, String)]) -> Result<Vec<u8>, ParquetError> {
    let field = |name: &str, kind: Physical, how: Repetition| {
        let logical = (kind == Physical::BYTE_ARRAY).then_some(LogicalType::String);
        let built =
            Type::primitive_type_builder(name, kind).with_repetition(how).with_logical_type(logical).build();
        built.map(Arc::new)
    };
    let mut fields = vec![field("case", Physical::INT64, Repetition::REQUIRED)?];
    for key in &table.keys {
        fields.push(field(key, Physical::BYTE_ARRAY, Repetition::REQUIRED)?);
    }
    for metric in &table.metrics {
        fields.push(field(metric, Physical::DOUBLE, Repetition::OPTIONAL)?);
    }
    let schema = Arc::new(Type::group_type_builder("sweep").with_fields(fields).build()?);
    let pairs = pairs.iter().map(|(key, value)| KeyValue::new((*key).to_owned(), value.clone())).collect();
    let properties = WriterProperties::builder().set_key_value_metadata(Some(pairs)).build();
    let mut file = SerializedFileWriter::new(Vec::new(), schema, Arc::new(properties))?;
    let mut rows = file.next_row_group()?;
    let mut number: usize = 0;
    while let Some(mut column) = rows.next_column()? {
        match number.checked_sub(1) {
            None => {
                let cases: Vec<i64> = (1..=table.rows.len() as i64).collect();
                column.typed::<Int64Type>().write_batch(&cases, None, None)?;
            }
            Some(key) if key < table.keys.len() => {
                let texts: Vec<ByteArray> =
                    table.rows.iter().map(|row| row[0][key].as_str().into()).collect();
                column.typed::<ByteArrayType>().write_batch(&texts, None, None)?;
            }
            Some(place) => {
                let metric = place - table.keys.len();
                let found: Vec<Option<f64>> =
                    table.rows.iter().map(|row| row[1][metric].parse().ok()).collect();
                let numbers: Vec<f64> = found.iter().flatten().copied().collect();
                let is_there: Vec<i16> = found.iter().map(|x| i16::from(x.is_some())).collect();
                column.typed::<DoubleType>().write_batch(&numbers, Some(&is_there), None)?;
            }
        }
        column.close()?;
        number += 1;
    }
    rows.close()?;
    file.into_inner()
}
