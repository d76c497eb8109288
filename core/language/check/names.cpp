#include "core/language/check/names.h"

#include <algorithm>
#include <array>

#include "core/language/library/functions.h"

namespace race::language {
namespace {

Reference invalid(ErrorCode code, std::string message, const Expr& e) {
  Reference r;
  r.meaning = Meaning::invalid;
  r.problem = {code, std::move(message), e.at};
  return r;
}

template <typename Map>
Reference place(Meaning meaning, const Map& map, std::string_view name, bool writable, const Expr& e) {
  const auto found = map.find(name);
  if (found == map.end()) return invalid(ErrorCode::unknown_name, std::string(name) + " is not declared here", e);
  Reference r;
  r.meaning = meaning;
  r.number = found->second;
  r.writable = writable;
  return r;
}

Reference incomplete(std::string_view name, const Expr& e) {
  return invalid(ErrorCode::scope, std::string(name) + " is no value by itself", e);
}

// par | par.x | res | res.x | var | var.x
Reference own(const Path& path, const Symbols& symbols, const Expr& e) {
  const std::string_view root = path.names[0];
  if (path.names.size() == 1) {
    Reference r;
    r.meaning = Meaning::collection;
    r.text = root;
    return r;
  }
  if (path.names.size() > 2) return {};
  if (root == "par") return place(Meaning::value, symbols.parameters, path.names[1], false, e);
  if (root == "res") return place(Meaning::value, symbols.results, path.names[1], true, e);
  const auto found = symbols.variables.find(path.names[1]);
  Reference r;  // variables need no declaration
  r.meaning = Meaning::value;
  r.number = found == symbols.variables.end() ? kNone : found->second;
  r.writable = true;
  return r;
}

// chi.C | chi.C.active | chi.C.name | chi.C.par.x | chi.C.res.x | chi.C.port.p
Reference child(const Path& path, const Symbols& symbols, const Expr& e) {
  const auto& names = path.names;
  if (names.size() == 1) return incomplete("chi", e);
  const auto found = symbols.children.find(names[1]);
  if (found == symbols.children.end())
    return invalid(ErrorCode::unknown_name, "there is no child " + std::string(names[1]), e);
  const ChildSymbols& child = found->second;
  Reference r;
  if (names.size() == 2 || names[2] == "active") {
    if (names.size() > 3) return {};
    r.meaning = Meaning::flag;
    r.number = child.active;
    return r;
  }
  if (names[2] == "name") {
    if (names.size() > 3) return {};
    r.meaning = Meaning::child_name;
    r.text = found->first;
    return r;
  }
  const bool part = names[2] == "par" || names[2] == "res" || names[2] == "port";
  if (!part || child.barrier)
    return invalid(ErrorCode::unknown_name, std::string(names[1]) + " has no " + std::string(names[2]), e);
  if (names.size() == 3) return incomplete(names[2], e);
  if (names.size() > 4) return {};
  if (names[2] == "par") return place(Meaning::value, child.parameters, names[3], false, e);
  if (names[2] == "res") return place(Meaning::value, child.results, names[3], false, e);
  return place(Meaning::flag, child.ports, names[3], false, e);
}

// svc.S.ev | svc.S.ev.latest | svc.S.op.result | svc.S.op.error, and with svc[e] for svc.S
Reference service(const Path& path, CodeKind kind, const Expr& e) {
  const auto& names = path.names;
  if (kind == CodeKind::expression)
    return invalid(ErrorCode::scope, "svc is not visible in a parameter's expression", e);
  if (names.size() < 3) return incomplete("svc", e);
  if (names.size() > 4) return {};
  Reference r;
  r.meaning = Meaning::data;
  if (names.size() == 4) {
    if (names[3] == "latest") {
      r.meaning = Meaning::latest;
    } else if (names[3] == "result") {
      r.meaning = Meaning::result;
    } else if (names[3] == "error") {
      r.meaning = Meaning::error;
    } else {
      return {};
    }
  }
  r.service = names[1];
  r.name = names[2];
  r.dynamic = path.service;
  return r;
}

// math.pi
Reference module(const Path& path, const Expr& e) {
  if (path.names.size() == 1) return incomplete(path.names[0], e);
  if (path.names.size() > 2) return {};
  Reference r;
  r.meaning = Meaning::constant;
  r.constant = find_constant(path.names[0], path.names[1]);
  if (r.constant != nullptr) return r;
  if (find_function(path.names[0], path.names[1]) != nullptr)
    return invalid(ErrorCode::scope, "a function is no value by itself", e);
  return invalid(ErrorCode::unknown_name, std::string(path.names[0]) + " has no " + std::string(path.names[1]), e);
}

void collect(const Block& block, std::vector<std::string>& names) {
  for (const Stmt& s : block) {
    for (const ExprPtr& target : s.targets)
      for_each_name(*target, [&](const Expr& name) {
        if (std::find(names.begin(), names.end(), name.name) == names.end()) names.push_back(name.name);
      });
    for (const Block& inner : s.blocks) collect(inner, names);
  }
}

}  // namespace

Path path_of(const Expr& e) {
  constexpr std::size_t kUsualNames = 5;  // svc.S.op.error.code
  Path path;
  path.names.reserve(kUsualNames);
  const Expr* at = &e;
  for (; at->kind == ExprKind::attribute; at = at->items[0].get()) path.names.push_back(at->name);
  if (at->kind == ExprKind::index && at->items[0]->kind == ExprKind::name && at->items[0]->name == "svc" &&
      at->items.size() > 1) {
    path.service = at->items[1].get();
    path.names.emplace_back();
    at = at->items[0].get();
  }
  if (at->kind != ExprKind::name) return {};
  path.names.push_back(at->name);
  std::reverse(path.names.begin(), path.names.end());
  return path;
}

Reference resolve(const Expr& e, CodeKind kind, const Symbols& symbols) {
  const Path path = path_of(e);
  if (path.names.empty()) return {};
  const std::string_view root = path.names[0];
  if (root == "par" || root == "res" || root == "var") return own(path, symbols, e);
  if (root == "chi") return child(path, symbols, e);
  if (root == "svc") return service(path, kind, e);
  if (root == "port") {
    if (kind == CodeKind::expression)
      return invalid(ErrorCode::scope, "port is not visible in a parameter's expression", e);
    if (path.names.size() == 1) return incomplete("port", e);
    if (path.names.size() > 2) return {};
    return place(Meaning::flag, symbols.ports, path.names[1], false, e);
  }
  if (is_module(root)) return module(path, e);
  if (is_builtin(root) && path.names.size() == 1)
    return invalid(ErrorCode::scope, "a function is no value by itself", e);
  return {};
}

bool is_collection(std::string_view name) {
  static constexpr std::array<std::string_view, 6> kCollections = {"par", "res", "var", "port", "chi", "svc"};
  return std::find(kCollections.begin(), kCollections.end(), name) != kCollections.end();
}

bool is_reserved(std::string_view name) { return is_collection(name) || is_builtin(name) || is_module(name); }

std::string_view root_of(const Expr& e) {
  const Expr* at = &e;
  while (at->kind == ExprKind::attribute || at->kind == ExprKind::index) at = at->items[0].get();
  return at->kind == ExprKind::name ? std::string_view(at->name) : std::string_view();
}

std::vector<std::string> assigned_names(const Block& block) {
  std::vector<std::string> names;
  collect(block, names);
  return names;
}

}  // namespace race::language
