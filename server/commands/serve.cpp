// race serve: cores, services and the browser clients, on loopback.
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

#include "server/application/application.h"
#include "server/commands/command.h"
#include "server/commands/config_file.h"
#include "server/commands/input.h"
#include "server/commands/load_operator_script.h"
#include "server/commands/service_manager.h"
#include "server/commands/settings.h"
#include "server/http/listener.h"
#include "server/log/line_log.h"
#include "server/tls/authority.h"
#include "server/tls/network_names.h"
#include "server/tls/renewal.h"
#include "server/wire/calendar.h"
#include "server/wire/version.h"

namespace race::server {
namespace {

namespace fs = std::filesystem;

// Numbers of messages go on where an earlier server can not have been: 1000 a millisecond since 1970.
std::int64_t first_sequence() { return now_ms() * 1000; }

struct Options {
  Settings settings;
  std::optional<std::string> config;
  bool check_config = false;
};

// Whether the folder holds anything of a demo: a cell or a document.
bool holds_demo(const fs::path& folder, std::error_code& unknown) {
  auto entry = fs::directory_iterator(folder, unknown);
  for (; !unknown && entry != fs::directory_iterator(); entry.increment(unknown)) {
    const std::string name = entry->path().filename();
    if (name == "cell.json" || name == "scene.json" || name == "database.json" || name.ends_with(".rcm.json"))
      return true;
  }
  return false;
}

// A demo of nothing is a slip in its name. (Of the configuration, an empty name is no demo.)
std::optional<FileErrors> check_demo(const Options& options, const Arguments& arguments) {
  const std::string &folder = options.settings.demo, option = "--demo";
  const bool is_option = arguments.given(option);
  const auto wrong = [&](ErrorCode code, const std::string& why) {
    return FileErrors{is_option ? "" : *options.config, {{code, why, is_option ? option : "demo"}}};
  };
  if (folder.empty() && is_option) return wrong(ErrorCode::missing, "the option needs a folder");
  std::error_code unknown;
  if (folder.empty() || holds_demo(folder, unknown)) return {};
  if (unknown) return wrong(ErrorCode::io, quote(folder) + " cannot be read: " + unknown.message());
  return wrong(ErrorCode::not_found,
               quote(folder) + " holds neither a cell (cell.json, scene.json) nor documents (*.rcm.json)");
}

// Reads the configuration into the settings, but for those that the command line gives; then checks them all.
std::vector<FileErrors> load_config(Options& options, const Arguments& arguments) {
  if (options.config) {
    const std::string& file = *options.config;
    const auto text = read_input(file);
    if (!text) return {{file, {text.error()}}};
    if (auto wrong = read_config(file, *text, arguments, options.settings); !wrong.empty()) return wrong;
  }
  auto errors = check_settings(options.settings);  // of options: the file has been checked
  if (errors.empty()) return {};
  for (Error& error : errors) error.path = "--" + error.path.substr(0, error.path.find('/'));
  return {{"", std::move(errors)}};
}

Application::Setup setup_of(const Settings& settings) {
  Application::Setup setup{settings.data, settings.demo, first_sequence()};
  setup.remote = settings.remote;
  setup.heartbeat = std::chrono::milliseconds(std::llround(settings.heartbeat_s * 1000));
  setup.retention = {static_cast<std::size_t>(settings.keep_runs),
                     static_cast<std::uint64_t>(settings.keep_mb * (std::uint64_t{1} << 20U))};
  return setup;
}

std::int64_t now_s() { return now_ms() / 1000; }

Expected<Authority> authority_of(const Settings& settings) {
  return Authority::open(fs::path(settings.data) / "tls", now_s());
}

// The network, with a certificate for this machine as it is known there. Errors: `not_accepted` (there is no account),
// `not_found` (the machine is in no private network), those of Authority.
Expected<HttpServer::Place> network_place(const Settings& settings, Application& app) {
  if (!app.has_accounts())
    return unexpected(
        ErrorCode::not_accepted,
        "a server in a network needs accounts: race account add NAME --role admin --data " + settings.data, "--lan");
  const std::vector<std::string> names = network_names();
  if (names.empty()) return unexpected(ErrorCode::not_found, "this machine is in no private network", "--lan");
  ASSIGN_OR_RETURN(const Authority authority, authority_of(settings));
  ASSIGN_OR_RETURN(ServerCertificate certificate, authority.certificate_for(names, now_s()));
  app.set_authority(authority.certificate(), authority.fingerprint());
  return HttpServer::Place{"::", static_cast<std::uint16_t>(settings.lan_port),
                           HttpServer::Place::Tls{names, std::move(certificate.chain), std::move(certificate.key)},
                           static_cast<std::uint16_t>(settings.lan_stop_port)};
}

Expected<std::vector<HttpServer::Place>> places_of(const Settings& settings, Application& app) {
  std::vector<HttpServer::Place> places = {
      {.port = static_cast<std::uint16_t>(settings.port), .stop_port = static_cast<std::uint16_t>(settings.stop_port)}};
  if (!settings.lan) return places;
  ASSIGN_OR_RETURN(HttpServer::Place network, network_place(settings, app));
  places.push_back(std::move(network));
  return places;
}

std::vector<std::string> urls_of(const HttpServer::Place::Tls& tls, std::uint16_t port) {
  std::vector<std::string> urls;
  for (const std::string& name : tls.names) {
    const std::string host = name.find(':') == std::string::npos ? name : '[' + name + ']';
    urls.push_back("https://" + host + ':' + std::to_string(port));
  }
  return urls;
}

void tell_network(std::vector<std::string> urls, Application& app, LineLog& log) {
  for (const std::string& url : urls) log.write(LogLevel::info, "server", "serves the network at " + url);
  app.set_addresses(std::move(urls));
  log.write(LogLevel::info, "server", "its authority, by SHA-256: " + app.authority_fingerprint());
}

// Of the network, while it is served.
Expected<std::unique_ptr<CertificateRenewal>> begin_renewal(const Settings& settings, const HttpServer::Place::Tls& tls,
                                                            HttpServer& server, LineLog& log) {
  ASSIGN_OR_RETURN(Authority authority, authority_of(settings));
  const auto renewed = [&server, &log](const Expected<ServerCertificate>& made) {
    const auto served = made ? server.set_certificate(1, made->chain, made->key) : tl::unexpected(made.error());
    if (served) return log.write(LogLevel::info, "server", "its certificate was renewed");
    log.write(LogLevel::error, "server", "its certificate cannot be renewed: " + to_string(served.error()));
  };
  return std::make_unique<CertificateRenewal>(CertificateRenewal::Subject{std::move(authority), tls.names, tls.chain},
                                              CertificateRenewal::Times{now_s}, renewed);
}

// The sockets have ended: the rest has this long. What the disk keeps for longer is as after a crash.
constexpr unsigned kEndTimeout = 6;  // [s]

void end_in_time() {
  std::signal(SIGALRM, [](int) {
    constexpr std::string_view kLine = "race: the disk or a service does not let the server end; it ends as it is\n";
    static_cast<void>(!::write(STDERR_FILENO, kLine.data(), kLine.size()));
    std::_Exit(kExitFindings);
  });
  ::alarm(kEndTimeout);
}

int serve(Options& options, const Arguments& arguments) {
  if (options.check_config && !options.config)
    return refuse(Error{ErrorCode::missing, "there is no configuration to check", "--config"});
  if (const auto wrong = load_config(options, arguments); !wrong.empty()) return refuse(wrong);
  const Settings& settings = options.settings;
  if (const auto wrong = check_demo(options, arguments)) return refuse(*wrong);
  Application::Setup setup = setup_of(settings);
  if (settings.operator_script) {
    auto script = load_operator_script(*settings.operator_script);
    if (!script) return refuse(script.error());
    setup.script = std::move(*script);
  }
  if (options.check_config) return kExitOk;
  std::signal(SIGPIPE, SIG_IGN);  // of a log that nobody reads any more
  std::signal(SIGHUP, SIG_IGN);   // of a terminal that is closed
  LineLog log(STDERR_FILENO, log_level_of(settings.log_level).value());
  setup.lines = &log;
  auto app = Application::create(setup);
  if (!app) return refuse(app.error());
  const auto places = places_of(settings, **app);
  if (!places) return refuse(places.error());
  // Without clients, no pages; the interface is there all the same.
  const std::string web = settings.headless ? "" : settings.web;
  auto server = HttpServer::listen(*places, web, (*app)->make_backend(), HttpServer::Limits());
  if (!server) return refuse(server.error());
  for (std::size_t place = 0; place < places->size(); ++place)
    (*app)->control().set_stop_port((*server)->port(place), (*server)->stop_port(place));
  const std::string address = "http://127.0.0.1:" + std::to_string((*server)->port());
  std::printf("race listens on %s\n", address.c_str());
  std::fflush(stdout);
  log.write(LogLevel::info, "server",
            "race " + std::string(version()) + " listens on " + address + ", data in " + settings.data);
  std::unique_ptr<CertificateRenewal> renewal;
  if (places->size() > 1) {
    const HttpServer::Place::Tls& tls = *places->back().tls;
    tell_network(urls_of(tls, (*server)->port(1)), **app, log);
    auto begun = begin_renewal(settings, tls, **server, log);
    if (!begun) return refuse(begun.error());
    renewal = std::move(*begun);
  }
  notify_manager("READY=1");
  (*server)->run();
  notify_manager("STOPPING=1");
  end_in_time();
  renewal.reset();
  (*app)->stop_replays();
  log.write(LogLevel::info, "server", "ends");
  return kExitOk;
}

std::function<int()> declare(Arguments& arguments) {
  const auto options = std::make_shared<Options>();
  declare_settings(arguments, options->settings);
  arguments.file("--config", "FILE", options->config,
                 "these settings as lines `keep-runs = 1000`, or as JSON; options come first");
  arguments.flag("--check-config", options->check_config, "checks --config and the options, and starts nothing");
  return [options, &arguments] { return serve(*options, arguments); };
}

}  // namespace

const Command kServe = {
    "serve", "serves cores, services and the browser clients on 127.0.0.1, until SIGTERM or SIGINT; SIGHUP is ignored",
    declare};

}  // namespace race::server
