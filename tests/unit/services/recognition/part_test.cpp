// Reading part files: what is accepted, which errors are reported.
#include "services/recognition/part.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/value/json.h"

namespace race::recognition {
namespace {

std::string file(const std::string& part) { return R"({"version": 1, "parts": [)" + part + "]}"; }
std::string piece(const std::string& shape, const std::string& colour = "#102030", const std::string& more = "") {
  return R"({"shape": )" + shape + R"(, "colour": ")" + colour + "\"" + more + "}";
}
std::string part(const std::string& pieces, const std::string& more = "") {
  return R"({"label": "A", "pieces": [)" + pieces + "]" + more + "}";
}

TEST(Parts, AreReadWithShapesColoursAndSymmetry) {
  const auto parts =
      read_parts(parse_json(file(part(piece(R"({"cylinder": [0.02, 0.08]})", "#102030",
                                            R"(, "pose": {"position": [0, 0, 0.1], "orientation": [1, 0, 0, 0]})"),
                                      R"(, "symmetry": [{"axis": [0, 0, 0.5], "order": 0}])")))
                     .value());
  ASSERT_TRUE(parts) << to_string(parts.error());
  const Part& read = parts->at(0);
  EXPECT_EQ(read.label, "A");
  EXPECT_EQ(read.pieces[0].kind, Piece::Kind::cylinder);
  EXPECT_EQ(read.pieces[0].size, (Vec3{0.02, 0.08, 0}));
  EXPECT_EQ(read.pieces[0].x_t_piece.position[2], 0.1);
  EXPECT_EQ(read.pieces[0].colour, (std::array<std::uint8_t, 3>{0x10, 0x20, 0x30}));
  EXPECT_EQ(read.symmetry[0].axis, (Vec3{0, 0, 1})) << "of length 1";
  const Box box = bounding_box(read);
  EXPECT_NEAR(box.middle[2], 0.1, 1e-12);
  EXPECT_NEAR(box.half[2], 0.04, 1e-12);
}

std::string marked(const std::string& id = "7", const std::string& side = "0.03",
                   const std::string& dictionary = "DICT_4X4_50", const std::string& more = "") {
  return part(piece(R"({"box": [0.05, 0.05, 0.05]})"),
              R"(, "markers": [{"dictionary": ")" + dictionary + R"(", "id": )" + id + R"(, "side": )" + side +
                  R"(, "pose": {"position": [0, 0, 0.025], "orientation": [0, 0, 0, 1]}}])" + more);
}

TEST(Parts, AreReadWithTheirMarkers) {
  const auto parts = read_parts(parse_json(file(marked())).value());
  ASSERT_TRUE(parts) << to_string(parts.error());
  ASSERT_EQ(parts->at(0).markers.size(), 1U);
  const Marker& marker = parts->at(0).markers[0];
  EXPECT_EQ(marker.id, 7);
  EXPECT_EQ(marker.side, 0.03);
  EXPECT_EQ(marker.x_t_marker.position, (Vec3{0, 0, 0.025}));
}

TEST(Parts, SayWhichMarkerTheyRefuse) {
  const auto parts = read_parts(parse_json(file(marked("50"))).value());
  ASSERT_FALSE(parts);
  EXPECT_EQ(parts.error().path, "parts[0].markers[0]");
  EXPECT_EQ(parts.error().message, "marker: `id` must be an int from 0 to 49");
}

TEST(Parts, RefuseMarkersThatAreNoNumbersInSize) {
  for (const char* field : {"id", "side"}) {
    Value document = parse_json(file(marked())).value();
    Value& part = document.mutable_dict().find(Value("parts"))->mutable_list()[0];
    Value& marker = part.mutable_dict().find(Value("markers"))->mutable_list()[0];
    marker.mutable_dict().set(field, std::numeric_limits<double>::quiet_NaN());
    const auto parts = read_parts(document);
    ASSERT_FALSE(parts) << field;
    EXPECT_EQ(name(parts.error().code), name(ErrorCode::constant)) << field;
  }
}

TEST(Parts, NameWhatTheyRefuse) {
  const std::string ball = R"({"sphere": [0.02]})";
  const std::vector<std::pair<std::string, ErrorCode>> cases = {
      {R"({"parts": []})", ErrorCode::missing},
      {R"({"version": 2, "parts": []})", ErrorCode::version},
      {file("3"), ErrorCode::type},
      {file(R"({"label": "A"})"), ErrorCode::missing},
      {file(part("")), ErrorCode::missing},
      {file(part(piece(R"({"cone": [1]})"))), ErrorCode::type},
      {file(part(piece(R"({"sphere": [-0.02]})"))), ErrorCode::out_of_range},
      {file(part(piece(R"({"sphere": ["a"]})"))), ErrorCode::out_of_range},
      {file(part(piece(R"({"box": [1, 1]})"))), ErrorCode::type},
      {file(part(piece(ball, "red"))), ErrorCode::type},
      {file(part(piece(ball, "#102030", R"(, "size": 3)"))), ErrorCode::unknown_field},
      {file(part(piece(ball) + "," + piece(ball, "#ff0000"))), ErrorCode::out_of_range},
      {file(part(piece(ball), R"(, "symmetry": [{"axis": [0, 0, 0], "order": 2}])")), ErrorCode::out_of_range},
      {file(part(piece(ball), R"(, "symmetry": [{"axis": [0, 0, 1], "order": 1.5}])")), ErrorCode::out_of_range},
      {file(part(piece(ball)) + "," + part(piece(ball))), ErrorCode::duplicate},
      {file(marked("7", "0.03", "DICT_5X5_50")), ErrorCode::unknown_name},
      {file(marked("50")), ErrorCode::out_of_range},
      {file(marked("-1")), ErrorCode::out_of_range},
      {file(marked("1.5")), ErrorCode::out_of_range},
      {file(marked("\"7\"")), ErrorCode::type},
      {file(marked("7", "0")), ErrorCode::out_of_range},
      {file(marked("7", "-0.03")), ErrorCode::out_of_range},
      {file(marked("7", "0.03", "DICT_4X4_50", R"(, "symmetry": [{"axis": [0, 0, 1], "order": 0}])")),
       ErrorCode::out_of_range},
      {file(part(piece(ball), R"(, "markers": [7])")), ErrorCode::type},
      {file(part(piece(ball), R"(, "markers": [{}])")), ErrorCode::missing},
  };
  for (const auto& [text, code] : cases) {
    const auto parts = read_parts(parse_json(text).value());
    ASSERT_FALSE(parts) << text;
    EXPECT_EQ(name(parts.error().code), name(code)) << text << ": " << to_string(parts.error());
  }
  EXPECT_EQ(load_parts("/nowhere/parts.json").error().code, ErrorCode::io);
}

}  // namespace
}  // namespace race::recognition
