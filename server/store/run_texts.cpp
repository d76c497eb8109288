#include "server/store/run_texts.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include "core/rsm/document.h"
#include "core/value/json.h"
#include "server/store/digest_column.h"
#include "server/store/journal_chain.h"
#include "server/store/run_row.h"

namespace race::server {
namespace {

std::string text_without_arguments(const execution::JournalHeader& header) {
  Value json = execution::header_json(header);
  json.mutable_dict().erase("arguments");
  return to_json(json);
}

std::string text_of(const std::map<std::string, rsm::Service>& services) {
  Dict json;
  for (const auto& [key, service] : services) json.set(key, rsm::write_service(service));
  return to_json(std::move(json));
}

// One that was damaged is whole again when it is stored again.
void write_text(Statements& statements, const sqlite::Digest& digest, const std::string& text) {
  const auto insert = statements.use(
      "INSERT INTO header VALUES (?, ?)"
      " ON CONFLICT DO UPDATE SET text = excluded.text WHERE text <> excluded.text");
  bind_digest(*insert, 1, digest);
  insert->bind(2, text);
  insert->exec();
}

Expected<Value> read_text(SQLite::Database& file, const sqlite::Digest& digest, RunId id, const char* what) {
  SQLite::Statement select(file, "SELECT text FROM header WHERE digest = ?");
  bind_digest(select, 1, digest);
  if (!select.executeStep()) return damaged(what, path_of(id));
  const std::string text = select.getColumn(0).getString();
  if (sqlite::sha256(text) != digest) return damaged(what, path_of(id));
  return parse_json(text, execution::kJournalLimits);
}

}  // namespace

RunTexts describe(const Runs::NewRun& run, RunRecord& record) {
  RunTexts texts = {text_without_arguments(run.header), text_of(run.services)};
  record.document = run.document;
  record.revision = run.revision;
  record.arguments = run.header.arguments;
  record.chain = header_chain(run.header);
  record.header = sqlite::sha256(texts.header);
  record.services = sqlite::sha256(texts.services);
  return texts;
}

void write_texts(Statements& statements, const RunRecord& run, const RunTexts& texts) {
  write_text(statements, run.header, texts.header);
  write_text(statements, run.services, texts.services);
}

Expected<Value> read_header_text(SQLite::Database& file, const RunRecord& run) {
  ASSIGN_OR_RETURN(const Value text, read_text(file, run.header, run.id, "the header"));
  Dict header;
  for (const auto& [key, value] : text.as_dict()) {
    header.set(key, value);
    if (key == Value("native")) header.set("arguments", run.arguments);
  }
  return Value(std::move(header));
}

Expected<Value> read_services_text(SQLite::Database& file, const RunRecord& run) {
  return read_text(file, run.services, run.id, "the list of services");
}

void remove_unused_texts(SQLite::Database& file) {
  file.exec("DELETE FROM header WHERE digest NOT IN (SELECT header FROM run UNION ALL SELECT services FROM run)");
}

}  // namespace race::server
