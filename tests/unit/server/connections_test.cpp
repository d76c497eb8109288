#include "server/http/connections.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace race::server {
namespace {

using Phase = Connections::Phase;
using testing::ElementsAre;
using testing::IsEmpty;

const std::string kHere = "127.0.0.1", kOther = "127.0.0.2";

// Connections that are numbered as they come, and which of them had to end.
struct ConnectionsTest : testing::Test {
  Connections::Place* come(const std::string& address = kHere, Phase phase = Phase::idle) {
    auto place = connections.admit(address, [this, number = ++number] { ended.push_back(number); });
    if (!place) return nullptr;
    place->begin(phase);
    places.push_back(std::move(place));
    return places.back().get();
  }

  Connections connections{{.all = 4, .of_address = 3, .websockets = 2, .reserved = 2}};
  std::vector<int> ended;
  std::vector<std::unique_ptr<Connections::Place>> places;
  int number = 0;
};

TEST_F(ConnectionsTest, TheLongestIdleOfTheAddressMakesWayWhenThatHasItsShare) {
  come(kOther);
  come();
  come()->begin(Phase::reading);
  auto* third = come();
  places[1]->begin(Phase::answering);
  places[1]->begin(Phase::idle);  // for a shorter time than the third
  EXPECT_FALSE(third->is_reserved());
  EXPECT_FALSE(come()->is_reserved());
  EXPECT_THAT(ended, ElementsAre(4));
  EXPECT_FALSE(come()->is_reserved());
  EXPECT_THAT(ended, ElementsAre(4, 2));
}

TEST_F(ConnectionsTest, TheAddressThatHasMostMakesWayWhenAllPlacesAreTaken) {
  come("127.0.0.3");
  come(kOther);
  come();
  come();
  EXPECT_FALSE(come(kOther)->is_reserved());
  EXPECT_THAT(ended, ElementsAre(3));
}

TEST_F(ConnectionsTest, WhereNoneIsIdleThePlaceIsAReservedOne) {
  for (const Phase phase : {Phase::reading, Phase::answering, Phase::websocket})
    EXPECT_FALSE(come(kHere, phase)->is_reserved());
  EXPECT_TRUE(come()->is_reserved());
  EXPECT_FALSE(come(kOther)->is_reserved()) << "another address has a share of its own";
  EXPECT_THAT(ended, IsEmpty());
}

TEST_F(ConnectionsTest, TheOldestReservedOneThatIsNotAnsweringMakesWay) {
  for (int i = 0; i < 3; ++i) come(kHere, Phase::answering);
  come()->begin(Phase::answering);
  come()->begin(Phase::reading);
  EXPECT_TRUE(come()->is_reserved());
  EXPECT_THAT(ended, ElementsAre(5));
  places.back()->begin(Phase::answering);
  EXPECT_EQ(come(), nullptr) << "both are answering";
  places[3]->begin(Phase::idle);
  EXPECT_TRUE(come()->is_reserved());
  EXPECT_THAT(ended, ElementsAre(5, 4));
}

TEST_F(ConnectionsTest, WhoHasLeftLeavesAPlace) {
  for (int i = 0; i < 3; ++i) come(kHere, Phase::answering);
  places.pop_back();
  EXPECT_FALSE(come()->is_reserved());
}

TEST_F(ConnectionsTest, WebSocketsAreFewerThanConnections) {
  EXPECT_TRUE(come()->begin_websocket());
  EXPECT_TRUE(come(kOther)->begin_websocket());
  EXPECT_FALSE(come(kOther)->begin_websocket());
  places.erase(places.begin());
  EXPECT_TRUE(come()->begin_websocket());
}

TEST_F(ConnectionsTest, AReservedPlaceIsForNoWebSocket) {
  for (int i = 0; i < 3; ++i) come(kHere, Phase::answering);
  EXPECT_FALSE(come()->begin_websocket());
}

TEST_F(ConnectionsTest, AtTheEndAllEndButThoseThatAreAnswering) {
  come();
  come(kHere, Phase::reading);
  come(kHere, Phase::answering);
  come(kOther, Phase::websocket)->on_end([this] { ended.push_back(0); });
  connections.end_all();
  EXPECT_THAT(ended, ElementsAre(1, 2, 0));
  EXPECT_FALSE(connections.empty());
  places.clear();
  EXPECT_TRUE(connections.empty());
}

}  // namespace
}  // namespace race::server
