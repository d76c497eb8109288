#include "server/cell/cell_file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "core/value/fields.h"
#include "core/value/json.h"
#include "server/store/files.h"
#include "services/remote/own_services.h"

namespace race::server {
namespace {

namespace fs = std::filesystem;
using remote::OwnServices;

constexpr std::size_t kMostAccounts = 200;  // as many as a server has

// What this program makes: the usual key of each type, in the order of a cell without a file.
struct KnownService {
  std::string_view key, type;
};
constexpr std::array kKnownServices = {
    KnownService{"robot", kRobotType},     KnownService{"gripper", kGripperType},
    KnownService{"camera", kCameraType},   KnownService{"obj_rec", kRecognitionType},
    KnownService{"db", kDatabaseType},     KnownService{"timer", kTimerType},
    KnownService{"display", kDisplayType}, KnownService{"audio", kAudioType},
};

std::string known_types() {
  std::string names;
  for (const KnownService& known : kKnownServices) names += (names.empty() ? "" : ", ") + std::string(known.type);
  return names;
}

// The key that a service of this type must have, if others find it by that.
std::string_view fixed_key(std::string_view type) {
  const auto known = std::ranges::find(kKnownServices, type, &KnownService::type);
  const bool is_reserved = std::ranges::find(OwnServices::kReserved, known->key) != OwnServices::kReserved.end();
  return is_reserved ? known->key : std::string_view();
}

class CellReader {
 public:
  CellReader(const std::string& folder, std::vector<Error>& errors) : folder_(folder), errors_(errors) {}

  void read(const Value& json, CellFile& cell) {
    Fields fields(json, "", "the cell", errors_, kByField);
    const Value* version = fields.find("cell", kRequired);
    if (version && *version != Value(1)) fields.violation(ErrorCode::version, "`cell` must be 1", "cell");
    cell.scene = file_of(fields, "scene");
    cell.parts = file_of(fields, "parts");
    cell.database = file_of(fields, "database");
    const Value* services = fields.find("services", kRequired);
    if (services) read_services(*services, fields, cell);
    if (const Value* expects = fields.find("expects")) read_expects(*expects, fields, cell);
    if (const Value* offers = fields.find("offers")) read_offers(*offers, cell);
    fields.close();
  }

 private:
  // Of this folder, so that a cell can be copied as it is.
  std::string file_of(Fields& fields, std::string_view key, Fields::Need need = Fields::Need::optional) {
    const auto name = fields.text(key, need);
    if (!name) return {};
    if (!name->empty() && name->find('/') == std::string::npos && *name != "." && *name != "..")
      return (fs::path(folder_) / *name).string();
    fields.violation(ErrorCode::name, quote(*name) + " is no name of a file in the folder of the cell", key);
    return {};
  }

  // Whether `json` is an object; each of its keys that is none of a service is a violation.
  bool has_keys(const Value& json, const std::string& field, Fields& fields) {
    if (!json.is_dict()) {
      fields.violation(ErrorCode::type, "must be an object by keys of services", field);
      return false;
    }
    for (const auto& [key, value] : json.as_dict())
      if (!is_name(key.as_string()) || key.as_string().size() > OwnServices::kKeyBytes)
        fields.violation(ErrorCode::name, quote(key.as_string()) + " is no key of a service", field);
    return true;
  }

  void read_services(const Value& json, Fields& fields, CellFile& cell) {
    if (!has_keys(json, "services", fields)) return;
    for (const auto& [key, type] : json.as_dict()) {
      const std::string field = "services/" + key.as_string();
      if (!type.is_string()) {
        fields.violation(ErrorCode::type, "must be the type of a service", field);
      } else if (!is_known_type(type.as_string())) {
        fields.violation(ErrorCode::not_found,
                         "this program has no service of type " + quote(type.as_string()) + "; it has " + known_types(),
                         field);
      } else if (const std::string_view fixed = fixed_key(type.as_string());
                 !fixed.empty() && fixed != key.as_string()) {
        fields.violation(ErrorCode::name, "others find this service by the key `" + std::string(fixed) + '`', field);
      } else if (cell.key_of(type.as_string())) {
        fields.violation(ErrorCode::duplicate, "the cell has a service of this type already", field);
      } else {
        cell.services.push_back({key.as_string(), type.as_string()});
      }
    }
  }

  void read_expects(const Value& json, Fields& fields, CellFile& cell) {
    if (!has_keys(json, "expects", fields)) return;
    if (json.as_dict().size() > OwnServices::kMost)
      return fields.violation(ErrorCode::too_large,
                              "a cell expects at most " + std::to_string(OwnServices::kMost) + " services", "expects");
    for (const auto& [key, value] : json.as_dict()) read_expected(key.as_string(), value, cell);
  }

  void read_expected(const std::string& key, const Value& json, CellFile& cell) {
    const std::string field = "expects/" + key;
    Fields fields(json, field, "an expected service", errors_, kByField);
    const auto is_same = [&](const CellFile::Service& service) { return service.key == key; };
    if (std::ranges::any_of(cell.services, is_same))
      fields.violation(ErrorCode::duplicate, "is a service of this program already");
    const auto type = fields.text("type", kRequired);
    const std::string file = file_of(fields, "rsm", kRequired);
    fields.close();
    if (!type || file.empty()) return;
    auto offer = read_rsm(key, *type, file);
    if (!offer) return errors_.push_back({offer.error().code, offer.error().message, field + "/rsm"});
    cell.expects.push_back({key, *type, *offer->model});
  }

  static Expected<remote::Offer> read_rsm(const std::string& key, const std::string& type, const std::string& file) {
    ASSIGN_OR_RETURN(const std::string text, read_file(file, OwnServices::kRsmBytes));
    ASSIGN_OR_RETURN(const Value json, parse_json(text));
    return OwnServices::read(key, type, json);
  }

  void read_offers(const Value& json, CellFile& cell) {
    Fields fields(json, "offers", "what is offered", errors_, kByField);
    std::vector<std::string> accounts = fields.texts("accounts", kRequired);
    fields.close();
    if (accounts.size() > kMostAccounts)
      return fields.violation(ErrorCode::too_large, "names at most " + std::to_string(kMostAccounts) + " accounts",
                              "accounts");
    cell.accounts.emplace(accounts.begin(), accounts.end());
  }

  const std::string& folder_;
  std::vector<Error>& errors_;
};

CellFile usual_cell(const std::string& folder) {
  CellFile cell;
  for (const KnownService& known : kKnownServices)
    cell.services.push_back({std::string(known.key), std::string(known.type)});
  if (folder.empty()) return cell;
  cell.scene = (fs::path(folder) / "scene.json").string();
  cell.parts = (fs::path(folder) / "parts.json").string();
  cell.database = (fs::path(folder) / "database.json").string();
  return cell;
}

}  // namespace

bool is_known_type(std::string_view type) {
  return std::ranges::any_of(kKnownServices, [&](const KnownService& known) { return known.type == type; });
}

std::optional<std::string> CellFile::key_of(std::string_view type) const {
  const auto found = std::ranges::find(services, type, &Service::type);
  if (found == services.end()) return std::nullopt;
  return found->key;
}

Expected<bool> CellFile::has(const std::string& file) const {
  if (file.empty()) return false;
  if (!path.empty()) return true;  // who reads it says what is wrong with it
  return file_exists(file);
}

Expected<void> CellFile::lacks(const std::string& key, const std::string& what) const {
  if (path.empty()) return {};
  return unexpected(ErrorCode::missing, "needs " + what, path + ": services/" + key);
}

Checked<CellFile> read_cell(const std::string& folder) {
  const auto refused = [](Error error) { return tl::unexpected(std::vector<Error>{std::move(error)}); };
  if (folder.empty()) return usual_cell(folder);
  const std::string path = fs::path(folder) / "cell.json";
  const auto is_there = file_exists(path);
  if (!is_there) return refused(is_there.error());
  if (!*is_there) return usual_cell(folder);
  const auto text = read_file(path);
  if (!text) return refused(text.error());
  const auto json = parse_json(*text);
  if (!json) return refused({json.error().code, json.error().message, path});
  CellFile cell;
  cell.path = path;
  std::vector<Error> errors;
  CellReader(folder, errors).read(*json, cell);
  for (Error& error : errors) error.path = path + (error.path.empty() ? "" : ": ") + error.path;
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return cell;
}

}  // namespace race::server
