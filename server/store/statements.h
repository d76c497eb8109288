// Statements: the statements of a connection that are executed again and again, each prepared once: to prepare one
// takes longer than to execute it.
//
// Threads: those of the connection.
#pragma once

#include <map>
#include <memory>
#include <string_view>

namespace SQLite {
class Database;
class Statement;
}  // namespace SQLite

namespace race::server {

class Statements {
 public:
  /// Requires that the connection outlives this.
  explicit Statements(SQLite::Database& file);
  ~Statements();
  Statements(const Statements&) = delete;
  Statements& operator=(const Statements&) = delete;

  /// A statement while it is executed. At the end, also after an exception, it is reset and its parameters are null: it
  /// keeps no transaction open and no text in memory.
  class Use {
   public:
    explicit Use(SQLite::Statement& statement) : statement_(statement) {}
    ~Use();
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;
    SQLite::Statement* operator->() const { return &statement_; }
    SQLite::Statement& operator*() const { return statement_; }

   private:
    SQLite::Statement& statement_;
  };
  /// Requires that `sql` is a literal, and that this statement is not in use. Throws SQLite::Exception.
  Use use(std::string_view sql);

  SQLite::Database& file() { return file_; }

 private:
  SQLite::Database& file_;
  std::map<std::string_view, std::unique_ptr<SQLite::Statement>> prepared_;
};

}  // namespace race::server
