// Connections: who is connected, and who makes way when there is no place left. Connections on which nothing is under
// way end first; beside all places some are reserved for connections of one short request (what they may ask for:
// serving.cpp), so that the server can be watched and its cores stopped whoever holds the others.
//
// Threads: one. Knows no sockets.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <string>

namespace race::server {

class Connections {
 public:
  /// At once. All greater than 0.
  struct Limits {
    std::size_t all = 512;         // beside the reserved
    std::size_t of_address = 448;  // of these
    std::size_t websockets = 384;  // of these
    std::size_t reserved = 16;
  };
  enum class Phase : std::uint8_t {
    idle,       // nothing is under way: before the first byte, between requests, or all is said
    reading,    // the header
    answering,  // from the end of the header until the answer has left
    websocket,  // or events
  };
  /// Ends a connection, soon; not before it returns.
  using End = std::function<void()>;

  class Place;

  explicit Connections(const Limits& limits) : limits_(limits) {}
  Connections(const Connections&) = delete;
  Connections& operator=(const Connections&) = delete;

  /// A place for a new connection, until it is destroyed (this outlives it). If all are taken, the connection ends that
  /// has been idle for longest, of the client's address if that has its share, else of the address that has most; if
  /// none is idle, the place is a reserved one, for which the oldest reserved connection makes way that is not
  /// answering. Nothing: not even that.
  std::unique_ptr<Place> admit(std::string address, End end);
  /// Ends all that are not answering.
  void end_all();
  bool empty() const { return entries_.empty(); }

 private:
  struct Entry {
    std::string address;
    End end;
    bool reserved = false;
    Phase phase = Phase::idle;
    std::uint64_t since = 0;  // of the phase; larger: later
    bool ended = false;       // has made way
  };
  using Entries = std::list<Entry>;

  std::size_t count(const std::function<bool(const Entry&)>& which) const;
  bool make_room(const std::string& address);
  bool make_reserved_room();
  Entry* find_idle(const std::string* address);
  static bool end(Entry* entry);

  const Limits limits_;
  Entries entries_;
  std::uint64_t phases_ = 0;  // begun so far
};

class Connections::Place {
 public:
  ~Place() { all_.entries_.erase(entry_); }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;

  bool is_reserved() const { return entry_->reserved; }
  void begin(Phase phase);
  /// It is a WebSocket from now on, or an answer that goes on (event_session.h). False: there are too many, or the
  /// place is a reserved one.
  bool begin_websocket();
  /// How the connection ends from now on.
  void on_end(End end) { entry_->end = std::move(end); }

 private:
  friend class Connections;
  Place(Connections& all, Entries::iterator entry) : all_(all), entry_(entry) {}

  Connections& all_;
  const Entries::iterator entry_;
};

}  // namespace race::server
