// POST /api/v1/runs: the file of a run, of this server or another one; checked whole, then stored under a new number.
#include <tuple>

#include "server/handlers/runs.h"
#include "server/http/refusal.h"
#include "server/http/request_filter.h"
#include "server/runs/run_file.h"
#include "server/runs/run_json.h"
#include "server/store/pictures.h"

namespace race::server {

static_assert(RequestFilter::kRunFileBytes == kRunFileLimits.bytes);

namespace {

struct SoundFile {
  RunFile file;
  std::map<std::uint64_t, std::string> checkpoints;
};

Checked<SoundFile> read(const std::string& text, const Stop& stop, WorkProgress* progress) {
  SoundFile sound;
  auto file = read_run_file_text(text, &sound.checkpoints, &stop, progress);
  if (!file) return tl::unexpected(std::move(file).error());
  sound.file = std::move(*file);
  return sound;
}

// What does not fit together in a file of a client is the client's mistake: nothing here is damaged.
Handled refuse(const std::vector<Error>& errors) {
  if (errors.front().code != ErrorCode::corrupt) return tl::unexpected(errors);
  return refusal(422, errors);
}

Handled store(const SoundFile& sound, WorkProgress* progress, Runs& runs, Samples& samples, Pictures& pictures) {
  const auto& [file, checkpoints] = sound;
  const Runs::NewRun run{file.record.document, file.record.revision, file.journal.header, file.services};
  const auto record =
      runs.import(file.record, run, file.journal.entries, checkpoints, file.timing, part_of_storing(progress, file));
  if (!record) return failed(record.error());
  auto stored = samples.append(record->id, file.samples);
  if (stored) stored = pictures.append(record->id, file.pictures);
  if (!stored) {
    std::ignore = runs.remove(record->id);  // whole or not at all
    return failed(std::move(stored).error());
  }
  return created(run_json(*record), "/api/v1/runs/" + std::to_string(record->id));
}

}  // namespace

void import_run(const Request& request, Respond respond, Runs& runs, Samples& samples, Pictures& pictures,
                Worker& replays) {
  replays.ask<SoundFile, std::vector<Error>>(
      [text = request.body, progress = request.progress](const Stop& stop) { return read(text, stop, progress.get()); },
      kReplayLimit, request.gone,
      [respond = std::move(respond), progress = request.progress, &runs, &samples,
       &pictures](const Checked<SoundFile>& sound) {
        respond(sound ? store(*sound, progress.get(), runs, samples, pictures) : refuse(sound.error()));
      });
}

}  // namespace race::server
