// Folder: a folder for files of one test, removed with all that is in it.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace race::sqlite {

class Folder {
 public:
  explicit Folder(const std::string& name)
      : path_(std::filesystem::weakly_canonical(std::filesystem::path(testing::TempDir()) / ("race_" + name))) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::string file(const std::string& name) const { return path_ / name; }

 private:
  const std::filesystem::path path_;
};

}  // namespace race::sqlite
