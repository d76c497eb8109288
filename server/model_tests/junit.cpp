#include "server/model_tests/junit.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace race::server {
namespace {

// XML 1.0 has no way to write control characters but these three.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else if (c == '\n')
      out += "&#10;";
    else if (c == '\t')
      out += "&#9;";
    else if (static_cast<unsigned char>(c) < 0x20)
      out += '?';
    else
      out += c;
  }
  return out;
}

std::string attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + escaped(value) + '"';
}

std::string seconds(double time) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3f", time);
  return text.data();
}

std::string counts(std::span<const TestOutcome> outcomes) {
  const auto failed = std::ranges::count_if(outcomes, [](const TestOutcome& each) { return !each.findings.empty(); });
  double time = 0;
  for (const TestOutcome& each : outcomes) time += each.time;
  return attribute("tests", std::to_string(outcomes.size())) + attribute("failures", std::to_string(failed)) +
         attribute("errors", "0") + attribute("time", seconds(time));
}

std::string test_case(const TestOutcome& test) {
  std::string out = "    <testcase" + attribute("classname", test.file) + attribute("name", test.name) +
                    attribute("time", seconds(test.time));
  if (test.findings.empty()) return out + "/>\n";
  std::string text;
  for (const Finding& each : test.findings) text += each.path + ": " + each.message + '\n';
  text += "seed " + std::to_string(test.seed) + '\n';
  return out + ">\n      <failure" +
         attribute("message", test.findings.front().path + ": " + test.findings.front().message) + ">" + escaped(text) +
         "</failure>\n    </testcase>\n";
}

}  // namespace

std::string junit_xml(std::span<const TestOutcome> outcomes) {
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + counts(outcomes) + ">\n";
  while (!outcomes.empty()) {
    const std::string& file = outcomes.front().file;
    const auto end = std::ranges::find_if(outcomes, [&](const TestOutcome& each) { return each.file != file; });
    const auto suite = outcomes.first(static_cast<std::size_t>(end - outcomes.begin()));
    out += "  <testsuite" + attribute("name", file) + counts(suite) + ">\n";
    for (const TestOutcome& each : suite) out += test_case(each);
    out += "  </testsuite>\n";
    outcomes = outcomes.subspan(suite.size());
  }
  return out + "</testsuites>\n";
}

}  // namespace race::server
