// WriteTransaction: a transaction that writes, in its turn. SQLite lets one connection write at a time, and others ask
// again now and then: beside one that writes without a pause they may wait for ever. Within a process, writers of
// one file therefore stand in line.
//
// Threads: any; it waits for its turn.
#pragma once

#include <memory>

namespace SQLite {
class Database;
class Transaction;
}  // namespace SQLite

namespace race::sqlite {

/// The turn alone: other writers of the process wait while it is there. For what SQLite writes outside of a transaction
/// of ours.
class WriteTurn {
 public:
  /// Waits for the writers that came before.
  explicit WriteTurn(const SQLite::Database& file);
  ~WriteTurn();
  WriteTurn(const WriteTurn&) = delete;
  WriteTurn& operator=(const WriteTurn&) = delete;

 private:
  class Line;
  static std::shared_ptr<Line> line_of(const SQLite::Database& file);
  const std::shared_ptr<Line> line_;  // held by those who stand in it
};

class WriteTransaction {
 public:
  /// Begins when the writers that came before have ended (BEGIN IMMEDIATE). Throws SQLite::Exception.
  explicit WriteTransaction(SQLite::Database& file);
  /// Rolls back what was not committed.
  ~WriteTransaction();
  WriteTransaction(const WriteTransaction&) = delete;
  WriteTransaction& operator=(const WriteTransaction&) = delete;
  /// Durable when it returns. Throws SQLite::Exception.
  void commit();

 private:
  const WriteTurn turn_;
  std::unique_ptr<SQLite::Transaction> transaction_;
};

}  // namespace race::sqlite
