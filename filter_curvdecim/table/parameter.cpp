// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_curvdecim/table/parameter.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <utility>

namespace curvdecim::glue {
namespace {

constexpr std::array python_keywords = {
    "and",    "as",   "assert", "async",  "await",  "break",   "class",    "continue",
    "def",    "del",  "elif",   "else",   "except", "finally", "for",      "from",
    "global", "if",   "import", "in",     "is",     "lambda",  "nonlocal", "not",
    "or",     "pass", "raise",  "return", "try",    "while",   "with",     "yield"};

bool fit_on_one_line(const std::vector<Choice>& choices) {
  constexpr std::size_t line = 70;  // characters that the dialog shows side by side
  std::size_t length = 0;
  for (const Choice& choice : choices)
    length += choice.name.size() + choice.hint.size() + std::strlen(": ; ");
  return length <= line;
}

std::string choices_help(const std::vector<Choice>& choices) {
  const char* const between = fit_on_one_line(choices) ? "; " : "<br>";
  std::string html;
  for (const Choice& choice : choices)
    html += (html.empty() ? "" : between) + ("<b>" + choice.name) + "</b>" +
            (choice.hint.empty() ? "" : ": ") + choice.hint;
  return html;
}

bool belongs_to_a_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// Where the word begins, from a place on, as a whole word; npos: nowhere.
std::size_t find_word(const std::string& text, const std::string& word, std::size_t from) {
  for (std::size_t at = text.find(word, from); at != std::string::npos;
       at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool begins = at == 0 || !belongs_to_a_name(text[at - 1]);
    if (begins && (end == text.size() || !belongs_to_a_name(text[end]))) return at;
  }
  return std::string::npos;
}

/// A field of one word may be an English word elsewhere, as in "threads is -1; it must be at least
/// 0 threads": only where it stands first it is surely the field.
void rename(std::string& text, const std::string& field, const std::string& name) {
  const bool unmistakable = field.find('_') != std::string::npos;
  std::size_t at = find_word(text, field, 0);
  while (at != std::string::npos) {
    text.replace(at, field.size(), name);
    at = unmistakable ? find_word(text, field, at + name.size()) : std::string::npos;
  }
}

}  // namespace

Value default_value(const Parameter& parameter, const MeshFacts& mesh) {
  return parameter.mesh_default ? parameter.mesh_default->value(mesh) : parameter.fixed_default;
}

std::string python_name(const Parameter& parameter) {
  std::string name = parameter.name;
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  const bool taken =
      std::find(python_keywords.begin(), python_keywords.end(), name) != python_keywords.end();
  return taken ? name + "_" : name;
}

std::string name_in_dialog(const Parameter& parameter) {
  return '\'' + parameter.label + "' (" + parameter.name + ')';
}

std::string dialog_help(const Parameter& parameter) {
  const std::string& hint = parameter.text.hint;
  const std::string choices = choices_help(parameter.choices);
  return hint + (hint.empty() || choices.empty() ? "" : "<br>") + choices;
}

InputError in_names_of(const std::vector<Parameter>& parameters, const InputError& error,
                       std::string (*shown)(const Parameter&)) {
  std::string message = error.what();
  std::vector<std::string> names = error.fields;
  for (std::string& name : names) {
    const auto parameter = std::find_if(parameters.begin(), parameters.end(),
                                        [&](const Parameter& each) { return each.field == name; });
    if (parameter == parameters.end()) continue;
    const std::string field = std::exchange(name, shown(*parameter));
    rename(message, field, name);
  }
  return InputError(message, names);
}

}  // namespace curvdecim::glue
