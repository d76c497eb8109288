#include "server/commands/prepare_tests.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "core/rcm/document.h"
#include "core/rcm/translate.h"
#include "core/rsm/document.h"
#include "server/cell/cell.h"
#include "server/cell/screen_services.h"
#include "server/commands/input.h"

namespace race::server {
namespace {

namespace fs = std::filesystem;

class Silent final : public services::HostObserver {
 public:
  void delivered(const services::Delivery&) override {}
  void changed(const services::ServiceStatus&) override {}
  void logged(services::Time, const std::string&, const std::string&) override {}
};

struct CellServices {
  Interfaces models;           // by key
  std::set<std::string> real;  // its timer and database, which a test without the cell has, too
};

// Any service may call its RSM `timer`: what a service is, the cell says.
std::set<std::string> real_services(const CellFile& cell) {
  std::set<std::string> keys;
  for (const std::string_view type : {kDatabaseType, kTimerType})
    if (auto key = cell.key_of(type)) keys.insert(std::move(*key));
  return keys;
}

class Preparation {
 public:
  /// Files, those of folders in their place.
  std::vector<std::string> files(const std::vector<std::string>& paths) {
    std::vector<std::string> out;
    for (const std::string& path : paths) {
      const std::vector<std::string> found = test_files(path);
      if (found.empty()) fail(path, Error{ErrorCode::not_found, "the folder has no file NAME.test.json"});
      out.insert(out.end(), found.begin(), found.end());
    }
    return out;
  }

  void read(const std::string& path) {
    const auto text = read_input(path);
    if (!text) return fail(path, text.error());
    auto file = read_test_text(*text);
    if (!file) return fail(path, std::move(file).error());
    const std::optional<std::string> model_file = model_of(path, *file);
    if (!model_file) return;
    const Model* model = load_model(*model_file, path, *file);
    if (!model) return;
    for (std::size_t i = 0; i < file->tests.size(); ++i)
      prepare(path, "tests/" + std::to_string(i), std::move(file->tests[i]), *model_file, *model);
  }

  tl::expected<PreparedTests, std::vector<FileErrors>> done() {
    if (!errors_.empty()) return tl::unexpected(std::move(errors_));
    return std::move(prepared_);
  }

 private:
  struct Model {
    rcm::Document document;
    std::string folder;
    CellServices cell;
  };

  void fail(const std::string& file, std::vector<Error> errors) {
    if (!errors.empty()) errors_.push_back({file, std::move(errors)});
  }
  void fail(const std::string& file, Error error) { fail(file, std::vector<Error>{std::move(error)}); }

  std::optional<std::string> model_of(const std::string& path, const TestFile& file) {
    auto model = model_file_of(path, file);
    if (!model) fail(path, Error{ErrorCode::missing, "names no model, and is not called NAME.test.json", "model"});
    return model;
  }

  // Once for all files that name it; nullptr: it cannot be used, which is said.
  const Model* load_model(const std::string& file, const std::string& test_file, const TestFile& tests) {
    if (const auto known = models_.find(file); known != models_.end()) return known->second ? &*known->second : nullptr;
    std::optional<Model>& model = models_[file];
    const auto text = read_input(file);
    if (!text) {
      fail(test_file,
           Error{text.error().code, file + ": " + text.error().message, std::string(tests.model ? "model" : "")});
      return nullptr;
    }
    auto document = rcm::read_document_text(*text);
    if (!document) {
      fail(file, std::move(document).error());
      return nullptr;
    }
    std::string folder = fs::path(file).parent_path().string();
    if (folder.empty()) folder = ".";
    const CellServices* cell = services_of(folder);
    if (!cell) return nullptr;
    model = Model{std::move(*document), std::move(folder), *cell};
    count_elements(file, *model);
    return &*model;
  }

  const CellServices* services_of(const std::string& folder) {
    if (const auto known = cells_.find(folder); known != cells_.end()) return &known->second;
    Silent silent;
    display::Screens screens;
    CellSetup setup;
    setup.folder = folder;
    setup.database = ":memory:";
    setup.own_threads = false;
    setup.extra_services = screen_services(screens, folder);
    auto cell = Cell::create(setup, silent);
    if (!cell) {
      fail("", cell.error());
      return nullptr;
    }
    const CellServices& services = cells_[folder] = {(*cell)->host().models(), real_services((*cell)->file())};
    (*cell)->stop();
    return &services;
  }

  // Of states of the library that cannot be roots there is nothing to cover.
  void count_elements(const std::string& file, const Model& model) {
    Coverage& coverage = prepared_.coverage[file];
    const auto add = [&](const rcm::Document& document, const std::string& library) {
      const auto native = rcm::translate(document);
      if (!native) return;
      if (const auto program = semantics::Program::build(*native, model.cell.models))
        coverage.add(**program, native->origin, library);
    };
    add(model.document, "");
    for (const rcm::State& state : model.document.library)
      if (const auto document = with_root(model.document, state.name)) add(*document, state.name);
  }

  void prepare(const std::string& file, const std::string& path, ModelTest test, const std::string& model_file,
               const Model& model) {
    PreparedTest out;
    out.file = file;
    out.path = path;
    out.model_file = model_file;
    out.folder = model.folder;
    std::vector<Error> errors;
    out.mocks = mocks_of(file, path, test, model.cell, errors);
    Interfaces services = model.cell.models;
    for (const auto& [key, service] : out.mocks) services[key] = service;
    out.document = model.document;
    if (test.state) {
      auto document = with_root(model.document, *test.state);
      if (!document)
        errors.push_back({document.error().code, document.error().message, path + "/state"});
      else
        out.document = std::move(*document);
    }
    if (!errors.empty()) return fail(file, std::move(errors));
    auto native = rcm::translate(out.document);
    if (!native) return fail(model_file, std::move(native).error());
    auto program = semantics::Program::build(*native, services);
    if (!program) return fail(model_file, std::move(program).error());
    check_test(test, **program, services, path, errors);
    out.origin = std::move(native->origin);
    out.program = std::move(*program);
    out.test = std::move(test);
    if (!errors.empty()) return fail(file, std::move(errors));
    prepared_.tests.push_back(std::move(out));
  }

  // The RSMs of the mocks of a test: those that it lists, and without the cell, all other services of that.
  Interfaces mocks_of(const std::string& file, const std::string& path, const ModelTest& test, const CellServices& cell,
                      std::vector<Error>& errors) {
    const Interfaces& of_cell = cell.models;
    Interfaces mocks;
    if (!test.cell)
      for (const auto& [key, service] : of_cell)
        if (!cell.real.contains(key) && !service.is_interface()) mocks[key] = service;
    for (const auto& [key, script] : test.services) {
      const std::string at = path + "/services/" + key;
      const auto known = of_cell.find(key);
      if (test.cell && known != of_cell.end()) {
        errors.push_back({ErrorCode::conflict, "the cell has this service: a mock cannot stand for it", at});
        continue;
      }
      std::optional<rsm::Service> model;
      if (script.rsm)
        model = read_rsm((fs::path(file).parent_path() / *script.rsm).string(), at + "/rsm", errors);
      else if (known != of_cell.end())
        model = known->second;
      else
        errors.push_back(
            {ErrorCode::missing, "the cell has no such service: `rsm` names a file that describes it", at});
      if (!model) continue;
      check_mock(script, *model, at, errors);
      mocks[key] = std::move(*model);
    }
    return mocks;
  }

  std::optional<rsm::Service> read_rsm(const std::string& file, const std::string& at, std::vector<Error>& errors) {
    const auto text = read_input(file);
    if (!text) {
      errors.push_back({text.error().code, file + ": " + text.error().message, at});
      return {};
    }
    auto service = rsm::read_service_text(*text, "");
    if (service) return std::move(*service);
    fail(file, service.error());
    errors.push_back({ErrorCode::reference, file + " is no description of a service", at});
    return {};
  }

  std::map<std::string, std::optional<Model>> models_;
  std::map<std::string, CellServices> cells_;  // by folder
  PreparedTests prepared_;
  std::vector<FileErrors> errors_;
};

}  // namespace

std::vector<std::string> test_files(const std::string& path) {
  std::error_code error;
  if (!fs::is_directory(path, error)) return {path};
  std::vector<std::string> found;
  for (fs::directory_iterator entry(path, error), end; !error && entry != end; entry.increment(error))
    if (entry->path().string().ends_with(kTestEnding)) found.push_back(entry->path().string());
  std::ranges::sort(found);
  return found;
}

std::optional<std::string> model_file_of(const std::string& test_file, const TestFile& content) {
  if (content.model) return (fs::path(test_file).parent_path() / *content.model).string();
  if (!test_file.ends_with(kTestEnding)) return {};
  return test_file.substr(0, test_file.size() - kTestEnding.size()) + std::string(kModelEnding);
}

tl::expected<PreparedTests, std::vector<FileErrors>> prepare_tests(const std::vector<std::string>& paths) {
  Preparation preparation;
  for (const std::string& file : preparation.files(paths)) preparation.read(file);
  return preparation.done();
}

}  // namespace race::server
