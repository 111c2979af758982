// SPDX-License-Identifier: Apache-2.0
/// A folder of its own for each test, gone afterwards: no two tests, nor two runs of one, share it.
#pragma once

#include <gtest/gtest.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>

namespace alidade::test {

class TempFolder {
  public:
    TempFolder() {
        std::string name = testing::TempDir() + "alidade_test_XXXXXX";
        if (!mkdtemp(name.data())) throw std::filesystem::filesystem_error(name, std::error_code(errno, std::generic_category()));
        path_ = name;
    }
    ~TempFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

class FolderTest : public testing::Test {
  protected:
    std::string at(const std::string& name) const { return (folder_ / name).string(); }
    std::string put(const std::string& name, std::string_view bytes) const {
        std::ofstream(at(name), std::ios::binary) << bytes;
        return at(name);
    }
    std::string text(const std::string& name) const {
        std::ifstream in(at(name), std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(in), {});
    }

  private:
    const TempFolder temporary_;

  protected:
    const std::filesystem::path& folder_ = temporary_.path();
};

}  // namespace alidade::test
