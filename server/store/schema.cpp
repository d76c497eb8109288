#include "server/store/schema.h"

#include <SQLiteCpp/Database.h>

#include <array>

#include "server/store/document_migrations.h"

namespace race::server {
namespace {

// 2: every run, with its header, its journal and its checkpoints.
//
// run.status: ready, running, interrupted, ended, faulted or aborted; steps: entries of the journal; chain: that of the
// last entry; times: milliseconds since 1970. header.text: schemas/journal.json, `header`, without `arguments`.
// entry.chain: sha256_of(chain before it, input); that before the first is of the whole header.
// sample: where everything in the cell was (schemas/cell_pose.json), each time `sampling.every` poses had come; seen:
// poses that had come; bytes: of those that are kept (samples.h).
void add_runs(SQLite::Database& file) {
  file.exec(
      "CREATE TABLE header (digest BLOB PRIMARY KEY, text TEXT NOT NULL) WITHOUT ROWID;"
      "CREATE TABLE run (id INTEGER PRIMARY KEY AUTOINCREMENT, document TEXT NOT NULL, revision INTEGER NOT NULL,"
      " header BLOB NOT NULL REFERENCES header (digest), services BLOB NOT NULL REFERENCES header (digest),"
      " arguments TEXT NOT NULL, status TEXT NOT NULL, outcome TEXT NOT NULL, fault TEXT NOT NULL,"
      " results TEXT NOT NULL, steps INTEGER NOT NULL, chain BLOB NOT NULL, created INTEGER NOT NULL,"
      " ended INTEGER NOT NULL, imported INTEGER NOT NULL, bytes INTEGER NOT NULL, digest BLOB NOT NULL);"
      "CREATE TABLE entry (run INTEGER NOT NULL, position INTEGER NOT NULL, input TEXT NOT NULL, chain BLOB NOT NULL,"
      " PRIMARY KEY (run, position)) WITHOUT ROWID;"
      "CREATE TABLE checkpoint (run INTEGER NOT NULL, position INTEGER NOT NULL, text TEXT NOT NULL,"
      " digest BLOB NOT NULL, PRIMARY KEY (run, position)) WITHOUT ROWID;"
      "CREATE TABLE sampling (run INTEGER PRIMARY KEY, seen INTEGER NOT NULL, every INTEGER NOT NULL,"
      " bytes INTEGER NOT NULL);"
      "CREATE TABLE sample (run INTEGER NOT NULL, number INTEGER NOT NULL, step INTEGER NOT NULL, pose TEXT NOT NULL,"
      " digest BLOB NOT NULL, PRIMARY KEY (run, number)) WITHOUT ROWID;");
}

// 4: what is started when the server begins. position: from 0; arguments: a JSON object.
void add_boot(SQLite::Database& file) {
  file.exec(
      "CREATE TABLE boot (position INTEGER PRIMARY KEY, document TEXT NOT NULL UNIQUE, arguments TEXT NOT NULL,"
      " digest BLOB NOT NULL)");
}

// 5: runs of which something may be left to be removed (run_removal.h).
void add_removals(SQLite::Database& file) {
  file.exec("CREATE TABLE removal (run INTEGER PRIMARY KEY, digest BLOB NOT NULL)");
}

// 6: revisions that edits have made, and texts that are stored as edits (revision_text.h): their `revision.text` is
// empty. depth: how many edits lead to the text from one that is stored whole; 0: this one is. request: the token that
// the client chose. edit: schemas/edit.json.
void add_edits(SQLite::Database& file) {
  file.exec(
      "CREATE TABLE revision_edit (document TEXT NOT NULL, number INTEGER NOT NULL, depth INTEGER NOT NULL,"
      " request TEXT NOT NULL, edit TEXT NOT NULL, digest BLOB NOT NULL, PRIMARY KEY (document, number))"
      " WITHOUT ROWID");
}

// 7: names of documents that were removed, in the order of their removal, with the last revision that each has had
// (document_removal.h).
void add_removed_documents(SQLite::Database& file) {
  file.exec(
      "CREATE TABLE removed_document (position INTEGER PRIMARY KEY AUTOINCREMENT, name TEXT NOT NULL UNIQUE,"
      " last INTEGER NOT NULL, digest BLOB NOT NULL)");
}

// 8: the breakpoints that people keep at documents (document_breakpoints.h). number: the larger, the later they were
// set; text: a JSON list of what api/schemas/document_breakpoints.json calls a kept breakpoint.
void add_breakpoints(SQLite::Database& file) {
  file.exec(
      "CREATE TABLE document_breakpoints (document TEXT NOT NULL, author TEXT NOT NULL, number INTEGER NOT NULL,"
      " text TEXT NOT NULL, digest BLOB NOT NULL, PRIMARY KEY (document, author)) WITHOUT ROWID");
}

// 9: the times of runs (run_timing.h). number: from 1, in order of time; last: the last macro step that a block has a
// time of; text: an item of api/schemas/timing_block.json; bytes: of it.
void add_timing(SQLite::Database& file) {
  file.exec(
      "CREATE TABLE timing (run INTEGER NOT NULL, number INTEGER NOT NULL, last INTEGER NOT NULL,"
      " bytes INTEGER NOT NULL, text TEXT NOT NULL, digest BLOB NOT NULL, PRIMARY KEY (run, number)) WITHOUT ROWID");
}

// 10: what cameras saw (pictures.h), as samples are; jpeg: base64.
void add_pictures(SQLite::Database& file) {
  file.exec(
      "CREATE TABLE picturing (run INTEGER PRIMARY KEY, seen INTEGER NOT NULL, every INTEGER NOT NULL,"
      " bytes INTEGER NOT NULL);"
      "CREATE TABLE picture (run INTEGER NOT NULL, number INTEGER NOT NULL, service TEXT NOT NULL,"
      " step INTEGER NOT NULL, time REAL NOT NULL, jpeg TEXT NOT NULL, digest BLOB NOT NULL,"
      " PRIMARY KEY (run, number)) WITHOUT ROWID;");
}

// 11: what was proposed (proposal.h). base: the revision that it changes, 0: it is a new document; status:
// Proposal::Status; times: milliseconds since 1970; revision: that accepting it has made, else 0; bytes: of `text`;
// text_digest: sha256(text). The digest of a row is of all fields but `text`, so that a list reads no texts.
void add_proposals(SQLite::Database& file) {
  file.exec(
      "CREATE TABLE proposal (id INTEGER PRIMARY KEY, document TEXT NOT NULL, base INTEGER NOT NULL,"
      " author TEXT NOT NULL, note TEXT NOT NULL, created INTEGER NOT NULL, status TEXT NOT NULL,"
      " decided_by TEXT NOT NULL, reason TEXT NOT NULL, decided INTEGER NOT NULL, revision INTEGER NOT NULL,"
      " bytes INTEGER NOT NULL, text_digest BLOB NOT NULL, digest BLOB NOT NULL, text TEXT NOT NULL)");
}

constexpr std::array<sqlite::Migration, 11> kMigrations = {
    give_document_ids,     add_runs,        add_revisions, add_boot,     add_removals, add_edits,
    add_removed_documents, add_breakpoints, add_timing,    add_pictures, add_proposals};

}  // namespace

std::span<const sqlite::Migration> store_migrations() { return kMigrations; }

}  // namespace race::server
