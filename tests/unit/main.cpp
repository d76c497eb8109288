// main() of every unit test program. Its target owns the tests' precompiled header (deploy/cmake/test.cmake).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

int main(int argc, char** argv) {
  testing::InitGoogleMock(&argc, argv);
  return RUN_ALL_TESTS();
}
