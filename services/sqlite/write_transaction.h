// WriteTransaction: a transaction that writes, in its turn. SQLite lets one connection write at a time, and others ask
// again now and then: beside one that writes without a pause they may never come round. Within a process, writers of
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
  class Line;
  class Turn;
  static std::shared_ptr<Line> line_of(const SQLite::Database& file);

  const std::unique_ptr<Turn> turn_;
  std::unique_ptr<SQLite::Transaction> transaction_;
};

}  // namespace race::sqlite
