//! What was found, as JSON in one language.

use crate::text::Lang;
use serde::Serialize;
use serde_json::Value;

/// `found` as JSON, with one string in the place of every text.
pub(super) fn spoken(found: &impl Serialize, lang: Lang) -> serde_json::Result<Value> {
    let mut value = serde_json::to_value(found)?;
    pick(&mut value, lang);
    Ok(value)
}

/// Puts one string in the place of every text in both languages.
pub(super) fn pick(value: &mut Value, lang: Lang) {
    match value {
        Value::Object(fields) if is_text(fields) => {
            *value = fields.remove(lang.pick(EN, DE)).unwrap_or_default();
        }
        Value::Object(fields) => fields.values_mut().for_each(|field| pick(field, lang)),
        Value::Array(list) => list.iter_mut().for_each(|item| pick(item, lang)),
        _ => {}
    }
}

/// Nothing else that we print has two fields with these names.
fn is_text(fields: &serde_json::Map<String, Value>) -> bool {
    fields.len() == 2 && [EN, DE].iter().all(|name| fields.get(*name).is_some_and(Value::is_string))
}

/// The fields of a serialised text.
const EN: &str = "en";
const DE: &str = "de";

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::Text;
    use serde_json::json;

    #[test]
    fn every_text_becomes_one_string() {
        let text = Text::new("fault", "Störung");
        let found = json!({ "a": [text, { "b": text, "de": "no text" }], "raw": 1.5 });
        assert_eq!(
            spoken(&found, Lang::De).unwrap(),
            json!({ "a": ["Störung", { "b": "Störung", "de": "no text" }], "raw": 1.5 })
        );
    }
}
