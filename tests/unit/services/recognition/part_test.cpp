// The door of part files.
#include "services/recognition/part.h"

#include <gtest/gtest.h>

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
