#include "tests/unit/services/sqlite/faulty_vfs.h"

#include <sqlite3.h>

#include <algorithm>
#include <cassert>
#include <cstring>
#include <fstream>
#include <map>
#include <mutex>
#include <random>
#include <string>
#include <vector>

namespace race::sqlite {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kSector = 512;

enum class Kind : std::uint8_t { open, create, read, write, sync, truncate, remove, extend };

bool needs_space(Kind kind) {
  return kind == Kind::create || kind == Kind::write || kind == Kind::sync || kind == Kind::extend;
}

int result_of(Kind kind, FaultyVfs::Fault fault) {
  const bool full = fault == FaultyVfs::Fault::full;
  switch (kind) {
    case Kind::open:
    case Kind::create:
      return SQLITE_CANTOPEN;
    case Kind::read:
      return SQLITE_IOERR_READ;
    case Kind::write:
      return full ? SQLITE_FULL : SQLITE_IOERR_WRITE;
    case Kind::sync:
      return full ? SQLITE_FULL : SQLITE_IOERR_FSYNC;
    case Kind::truncate:
      return SQLITE_IOERR_TRUNCATE;
    case Kind::remove:
      return SQLITE_IOERR_DELETE;
    case Kind::extend:
      return SQLITE_IOERR_SHMSIZE;
  }
  return SQLITE_IOERR;
}

/// A write, or a truncation to `offset`.
struct Change {
  bool truncation;
  std::size_t offset;
  std::string bytes;
};

struct FileModel {
  bool there = false;        // after a loss of power
  bool removed = false;      // which a loss of power may undo
  std::string synchronised;  // content
  std::vector<Change> since;
};

void apply_write(std::string& content, std::size_t offset, std::string_view bytes) {
  if (content.size() < offset + bytes.size()) content.resize(offset + bytes.size(), '\0');
  content.replace(offset, bytes.size(), bytes);
}

/// The sectors of a write, each if `keep` says so.
template <typename Keep>
void apply(std::string& content, const Change& change, Keep keep) {
  if (change.truncation) {
    if (keep() && change.offset < content.size()) content.resize(change.offset);
    return;
  }
  for (std::size_t at = 0; at < change.bytes.size();) {
    const std::size_t length = std::min(kSector - (change.offset + at) % kSector, change.bytes.size() - at);
    if (keep()) apply_write(content, change.offset + at, std::string_view(change.bytes).substr(at, length));
    at += length;
  }
}

std::string read_whole(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

bool is_below(const fs::path& path, const fs::path& folder) {
  const fs::path relative = path.lexically_relative(folder);
  return !relative.empty() && *relative.begin() != "..";
}

}  // namespace

struct FaultyVfs::State {
  sqlite3_vfs* below = nullptr;
  sqlite3_vfs vfs = {};

  mutable std::mutex mutex;
  std::map<fs::path, std::shared_ptr<FileModel>> files;
  std::function<void(std::uint64_t)> hook;
  std::uint64_t operations = 0;
  std::uint64_t until_fault = 0;  // 0: none is to come
  Fault fault = Fault::io;
  bool for_ever = false, failing = false, failed = false, skip_syncs = false;

  /// Counts an operation; SQLITE_OK, or what it fails with.
  int begin(Kind kind) {
    thread_local bool in_hook = false;
    if (in_hook) return SQLITE_OK;
    std::function<void(std::uint64_t)> before;
    std::uint64_t number = 0;
    {
      const std::lock_guard lock(mutex);
      number = ++operations;
      before = hook;
    }
    in_hook = true;
    if (before) before(number);
    in_hook = false;
    const std::lock_guard lock(mutex);
    if (fault == Fault::full && !needs_space(kind)) return SQLITE_OK;
    if (until_fault > 0 && --until_fault == 0) failing = true;
    if (!failing) return SQLITE_OK;
    failing = for_ever;
    failed = true;
    return result_of(kind, fault);
  }

  void synchronise_folder(const fs::path& folder) {
    std::erase_if(files, [&](const auto& file) { return file.second->removed && file.first.parent_path() == folder; });
    for (auto& [path, file] : files)
      if (path.parent_path() == folder) file->there = true;
  }
};

namespace {

/// What SQLite holds of an open file; that of the VFS below stands behind it.
struct OpenFile {
  sqlite3_file base;
  FaultyVfs::State* state;
  std::shared_ptr<FileModel> model;  // none: a temporary file; shared by all who have it open and the list of files
  fs::path path;
  bool is_log;  // a journal or a write-ahead log

  sqlite3_file* below() { return reinterpret_cast<sqlite3_file*>(this + 1); }
};

OpenFile& of(sqlite3_file* file) { return *reinterpret_cast<OpenFile*>(file); }
const sqlite3_io_methods& below(sqlite3_file* file) { return *of(file).below()->pMethods; }

void note(OpenFile& file, Change change) {
  const std::lock_guard lock(file.state->mutex);
  if (file.model) file.model->since.push_back(std::move(change));
}

int close(sqlite3_file* file) {
  const int result = below(file).xClose(of(file).below());
  of(file).~OpenFile();
  return result;
}

int read(sqlite3_file* file, void* data, int size, sqlite3_int64 offset) {
  if (const int result = of(file).state->begin(Kind::read); result != SQLITE_OK) return result;
  return below(file).xRead(of(file).below(), data, size, offset);
}

int write(sqlite3_file* file, const void* data, int size, sqlite3_int64 offset) {
  const int fault = of(file).state->begin(Kind::write);
  if (fault == SQLITE_FULL) size /= 2;
  if (fault != SQLITE_OK && fault != SQLITE_FULL) return fault;
  note(of(file), {false, static_cast<std::size_t>(offset),
                  std::string(static_cast<const char*>(data), static_cast<std::size_t>(size))});
  const int result = below(file).xWrite(of(file).below(), data, size, offset);
  return fault == SQLITE_OK ? result : fault;
}

int truncate(sqlite3_file* file, sqlite3_int64 size) {
  if (const int result = of(file).state->begin(Kind::truncate); result != SQLITE_OK) return result;
  note(of(file), {true, static_cast<std::size_t>(size), ""});
  return below(file).xTruncate(of(file).below(), size);
}

// The disk below is not synchronised: what counts is the model.
int sync(sqlite3_file* file, int) {
  if (const int result = of(file).state->begin(Kind::sync); result != SQLITE_OK) return result;
  OpenFile& open = of(file);
  const std::lock_guard lock(open.state->mutex);
  if (!open.model || open.state->skip_syncs) return SQLITE_OK;
  for (const Change& change : open.model->since) apply(open.model->synchronised, change, [] { return true; });
  open.model->since.clear();
  if (open.is_log && !open.model->there) open.state->synchronise_folder(open.path.parent_path());
  open.model->there = true;
  return SQLITE_OK;
}

int file_size(sqlite3_file* file, sqlite3_int64* size) { return below(file).xFileSize(of(file).below(), size); }
int lock(sqlite3_file* file, int level) { return below(file).xLock(of(file).below(), level); }
int unlock(sqlite3_file* file, int level) { return below(file).xUnlock(of(file).below(), level); }
int check_lock(sqlite3_file* file, int* held) { return below(file).xCheckReservedLock(of(file).below(), held); }
int control(sqlite3_file* file, int what, void* argument) {
  return below(file).xFileControl(of(file).below(), what, argument);
}
int sector_size(sqlite3_file* file) { return below(file).xSectorSize(of(file).below()); }
int characteristics(sqlite3_file* file) { return below(file).xDeviceCharacteristics(of(file).below()); }

int map_shared(sqlite3_file* file, int page, int size, int extend, void volatile** memory) {
  if (extend != 0)
    if (const int result = of(file).state->begin(Kind::extend); result != SQLITE_OK) return result;
  return below(file).xShmMap(of(file).below(), page, size, extend, memory);
}
int lock_shared(sqlite3_file* file, int offset, int count, int flags) {
  return below(file).xShmLock(of(file).below(), offset, count, flags);
}
void barrier(sqlite3_file* file) { below(file).xShmBarrier(of(file).below()); }
int unmap_shared(sqlite3_file* file, int remove) { return below(file).xShmUnmap(of(file).below(), remove); }

// Version 2: no memory mapping of the file itself, which would be I/O that is not seen.
constexpr sqlite3_io_methods kMethods = {
    2,          close,   read,        write,           truncate,   sync,        file_size, lock,         unlock,
    check_lock, control, sector_size, characteristics, map_shared, lock_shared, barrier,   unmap_shared, nullptr,
    nullptr};

FaultyVfs::State& of(sqlite3_vfs* vfs) { return *static_cast<FaultyVfs::State*>(vfs->pAppData); }

int open(sqlite3_vfs* vfs, sqlite3_filename name, sqlite3_file* file, int flags, int* flags_out) {
  FaultyVfs::State& state = of(vfs);
  file->pMethods = nullptr;
  const bool is_new = name && !fs::exists(name);
  if (const int result = state.begin(is_new || !name ? Kind::create : Kind::open); result != SQLITE_OK) return result;
  sqlite3_file* below = reinterpret_cast<sqlite3_file*>(reinterpret_cast<OpenFile*>(file) + 1);
  if (const int result = state.below->xOpen(state.below, name, below, flags, flags_out); result != SQLITE_OK)
    return result;
  const bool is_log = (flags & (SQLITE_OPEN_WAL | SQLITE_OPEN_MAIN_JOURNAL)) != 0;
  OpenFile& open = *new (file) OpenFile{{&kMethods}, &state, nullptr, name ? name : "", is_log};
  if (!name || (flags & SQLITE_OPEN_DELETEONCLOSE) != 0) return SQLITE_OK;
  const std::lock_guard lock(state.mutex);
  std::shared_ptr<FileModel>& model = state.files[open.path];
  if (is_new) model = std::make_shared<FileModel>();
  if (!model) model = std::make_shared<FileModel>(FileModel{true, false, read_whole(name), {}});
  open.model = model;
  return SQLITE_OK;
}

int remove(sqlite3_vfs* vfs, const char* name, int synchronise) {
  FaultyVfs::State& state = of(vfs);
  if (const int result = state.begin(Kind::remove); result != SQLITE_OK) return result;
  const int result = state.below->xDelete(state.below, name, 0);
  const std::lock_guard lock(state.mutex);
  if (const auto found = state.files.find(name); found != state.files.end() && result == SQLITE_OK)
    found->second->removed = true;
  if (synchronise != 0) state.synchronise_folder(fs::path(name).parent_path());
  return result;
}

int is_there(sqlite3_vfs* vfs, const char* name, int flags, int* found) {
  return of(vfs).below->xAccess(of(vfs).below, name, flags, found);
}
int full_path(sqlite3_vfs* vfs, const char* name, int size, char* path) {
  return of(vfs).below->xFullPathname(of(vfs).below, name, size, path);
}
int randomness(sqlite3_vfs* vfs, int size, char* bytes) {
  return of(vfs).below->xRandomness(of(vfs).below, size, bytes);
}
int sleep(sqlite3_vfs* vfs, int microseconds) { return of(vfs).below->xSleep(of(vfs).below, microseconds); }
int now(sqlite3_vfs* vfs, double* days) { return of(vfs).below->xCurrentTime(of(vfs).below, days); }
int last_error(sqlite3_vfs* vfs, int size, char* text) {
  return of(vfs).below->xGetLastError(of(vfs).below, size, text);
}
int now_ms(sqlite3_vfs* vfs, sqlite3_int64* ms) { return of(vfs).below->xCurrentTimeInt64(of(vfs).below, ms); }

}  // namespace

FaultyVfs::FaultyVfs() : state_(std::make_unique<State>()) {
  sqlite3_initialize();
  state_->below = sqlite3_vfs_find(nullptr);
  assert(std::strcmp(state_->below->zName, "race_faulty") != 0);
  sqlite3_vfs& vfs = state_->vfs;
  vfs.iVersion = 2;
  vfs.szOsFile = static_cast<int>(sizeof(OpenFile)) + state_->below->szOsFile;
  vfs.mxPathname = state_->below->mxPathname;
  vfs.zName = "race_faulty";
  vfs.pAppData = state_.get();
  vfs.xOpen = open;
  vfs.xDelete = remove;
  vfs.xAccess = is_there;
  vfs.xFullPathname = full_path;
  vfs.xRandomness = randomness;
  vfs.xSleep = sleep;
  vfs.xCurrentTime = now;
  vfs.xGetLastError = last_error;
  vfs.xCurrentTimeInt64 = now_ms;
  sqlite3_vfs_register(&vfs, 1);
}

FaultyVfs::~FaultyVfs() {
  sqlite3_vfs_unregister(&state_->vfs);
  sqlite3_vfs_register(state_->below, 1);
}

std::uint64_t FaultyVfs::operations() const {
  const std::lock_guard lock(state_->mutex);
  return state_->operations;
}

void FaultyVfs::fail_at(std::uint64_t nth, Fault fault, bool for_ever) {
  const std::lock_guard lock(state_->mutex);
  state_->until_fault = nth;
  state_->fault = fault;
  state_->for_ever = for_ever;
  state_->failing = state_->failed = false;
}

void FaultyVfs::repair() {
  const std::lock_guard lock(state_->mutex);
  state_->until_fault = 0;
  state_->failing = false;
}

bool FaultyVfs::has_failed() const {
  const std::lock_guard lock(state_->mutex);
  return state_->failed;
}

void FaultyVfs::before_each(std::function<void(std::uint64_t operation)> hook) {
  const std::lock_guard lock(state_->mutex);
  state_->hook = std::move(hook);
}

void FaultyVfs::skip_syncs(bool skip) {
  const std::lock_guard lock(state_->mutex);
  state_->skip_syncs = skip;
}

void FaultyVfs::lose_power(const fs::path& from, const fs::path& to, double kept, std::uint64_t seed) const {
  fs::remove_all(to);
  fs::create_directories(to);
  std::mt19937_64 random(seed);
  const auto keep = [&] { return std::bernoulli_distribution(kept)(random); };
  const fs::path folder = fs::canonical(from);
  const std::lock_guard lock(state_->mutex);
  for (const auto& [path, file] : state_->files) {
    if (!is_below(path, folder)) continue;
    const bool is_there = file->removed ? file->there && !keep() : file->there || keep();
    if (!is_there) continue;
    std::string content = file->synchronised;
    for (const Change& change : file->since) apply(content, change, keep);
    const fs::path copy = to / path.lexically_relative(folder);
    fs::create_directories(copy.parent_path());
    std::ofstream(copy, std::ios::binary) << content;
  }
}

}  // namespace race::sqlite
