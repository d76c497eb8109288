// Exposition: metrics as Prometheus reads them (text format 0.0.4): families with HELP and TYPE, and their samples.
//
// Threads: one.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace race::server {

class Exposition {
 public:
  using Labels = std::initializer_list<std::pair<std::string_view, std::string_view>>;
  static constexpr std::string_view kType = "text/plain; version=0.0.4; charset=utf-8";

  /// A family begins, whose samples follow; each once. `type`: "counter", "gauge" or "histogram"; `help`: one line.
  void family(std::string_view name, std::string_view type, std::string_view help);
  /// Of the family, whose name it has, in a histogram with _bucket, _sum or _count behind it. Values of labels may be
  /// any UTF-8.
  void sample(std::string_view name, Labels labels, double value);
  /// A family of one sample without labels.
  void single(std::string_view name, std::string_view type, std::string_view help, double value) {
    family(name, type, help);
    sample(name, {}, value);
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace race::server
