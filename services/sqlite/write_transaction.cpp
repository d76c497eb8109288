#include "services/sqlite/write_transaction.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Transaction.h>

#include <cstdint>
#include <map>
#include <string>

#include "services/mutex.h"

namespace race::sqlite {

// Those who write one file, in order of arrival.
class WriteTurn::Line {
 public:
  void enter() EXCLUDES(mutex_) {
    const services::MutexLock lock(mutex_);
    const std::uint64_t mine = last_++;
    left_.wait(mutex_, [this, mine]() REQUIRES(mutex_) { return first_ == mine; });
  }
  void leave() EXCLUDES(mutex_) {
    {
      const services::MutexLock lock(mutex_);
      ++first_;
    }
    left_.notify_all();
  }

 private:
  services::Mutex mutex_;
  services::ConditionVariable left_;
  std::uint64_t first_ GUARDED_BY(mutex_) = 0, last_ GUARDED_BY(mutex_) = 0;
};

std::shared_ptr<WriteTurn::Line> WriteTurn::line_of(const SQLite::Database& file) {
  static services::Mutex mutex;
  static std::map<std::string, std::weak_ptr<Line>> lines;
  const services::MutexLock lock(mutex);
  std::erase_if(lines, [](const auto& each) { return each.second.expired(); });
  auto& known = lines[file.getFilename()];
  auto line = known.lock();
  if (!line) known = line = std::make_shared<Line>();
  return line;
}

WriteTurn::WriteTurn(const SQLite::Database& file) : line_(line_of(file)) { line_->enter(); }
WriteTurn::~WriteTurn() { line_->leave(); }

WriteTransaction::WriteTransaction(SQLite::Database& file)
    : turn_(file), transaction_(std::make_unique<SQLite::Transaction>(file, SQLite::TransactionBehavior::IMMEDIATE)) {}

WriteTransaction::~WriteTransaction() = default;

void WriteTransaction::commit() { transaction_->commit(); }

}  // namespace race::sqlite
