// FaultyVfs: a disk for tests of what SQLite stores. It is an SQLite VFS (https://sqlite.org/vfs.html, "VFS shims")
// over the usual one and the default while it lives. It fails, is full, and tells what a loss of power would leave.
//
// Model of a loss of power: of each file, what was synchronised is there; of each write and truncation since, sectors
// of 512 bytes are there or not, each on its own. A file that was made or removed is so when its folder is
// synchronised: with the first synchronisation of a new journal or log, as the usual VFS does it.
//
// Threads: any. Connections that were opened while it lives are closed before it ends; one lives at a time.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>

namespace race::sqlite {

class FaultyVfs {
 public:
  enum class Fault : std::uint8_t {
    full,  // writes, synchronisations, and what makes or extends a file; half of a failing write arrives
    io,    // every operation: reads, truncations and removals too
  };

  FaultyVfs();
  ~FaultyVfs();
  FaultyVfs(const FaultyVfs&) = delete;
  FaultyVfs& operator=(const FaultyVfs&) = delete;

  /// Operations so far: open, read, write, synchronise, truncate, remove, extend the shared memory.
  std::uint64_t operations() const;

  /// The `nth` operation from now (from 1) of those that `fault` concerns fails, and with `for_ever` all after it.
  void fail_at(std::uint64_t nth, Fault fault, bool for_ever);
  /// Nothing fails any more.
  void repair();
  /// Whether something has failed since fail_at().
  bool has_failed() const;

  /// Called before each operation, with its number from 1, on the thread that does it. What the hook itself does is
  /// neither counted nor fails: it may call lose_power() and open what that left.
  void before_each(std::function<void(std::uint64_t operation)> hook);
  /// A disk that says it has synchronised and has not.
  void skip_syncs(bool skip);

  /// Files below `from` as a loss of power would leave them now, below `to`, which is emptied before. Each sector that
  /// was not synchronised is there with the probability `kept`: 0, all is lost; 1, as after a crash of the process.
  void lose_power(const std::filesystem::path& from, const std::filesystem::path& to, double kept = 0,
                  std::uint64_t seed = 0) const;

  struct State;

 private:
  const std::unique_ptr<State> state_;
};

}  // namespace race::sqlite
