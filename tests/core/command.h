#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "cloud/samples.h"
#include "io/writers.h"

namespace plateau {

/// How the command ended and what it said.
struct Outcome {
    int code = -1;
    std::string output;
    std::string error;
};

inline std::string contents(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// Drives the built command as a process, in a folder of its own.
class Command : public testing::Test {
protected:
    void SetUp() override {
        std::string pattern = testing::TempDir() + "plateau-cli-XXXXXX";
        ASSERT_NE(mkdtemp(pattern.data()), nullptr);
        folder_ = pattern;
    }
    void TearDown() override {
        const int removed = std::system(("rm -r " + folder_).c_str());
        EXPECT_EQ(removed, 0);
    }

    std::string path(const std::string& name) const { return folder_ + "/" + name; }
    std::string written(const std::string& name, const std::string& text) const {
        std::ofstream(path(name), std::ios::binary) << text;
        return path(name);
    }

    /// Starts the command; standard output and error go to files, unless an open descriptor is given for output.
    pid_t started(const std::vector<std::string>& arguments, int output = -1) const {
        const std::string input_path = path("stdin");
        const std::string output_path = path("stdout");
        const std::string error_path = path("stderr");
        std::vector<std::string> words = {PLATEAU_BINARY};
        words.insert(words.end(), arguments.begin(), arguments.end());
        std::vector<char*> pointers;
        for (std::string& word : words) pointers.push_back(word.data());
        pointers.push_back(nullptr);
        const pid_t child = fork();
        if (child != 0) return child;
        dup2(open(input_path.c_str(), O_RDONLY | O_CREAT, 0600), 0);
        dup2(output >= 0 ? output : open(output_path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), 1);
        dup2(open(error_path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), 2);
        execv(pointers[0], pointers.data());
        _exit(127);
    }

    Outcome ended(pid_t child) const {
        int status = 0;
        waitpid(child, &status, 0);
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), contents(path("stdout")),
                contents(path("stderr"))};
    }

    Outcome plateau(const std::vector<std::string>& arguments, const std::string& input = "") const {
        written("stdin", input);
        return ended(started(arguments));
    }

    /// Exit 2, nothing on standard output, exactly one line on standard error; returns that line.
    std::string refused(const std::vector<std::string>& arguments, const std::string& input = "") const {
        const Outcome outcome = plateau(arguments, input);
        std::string all;
        for (const std::string& argument : arguments) all += argument + " ";
        EXPECT_EQ(outcome.code, 2) << all;
        EXPECT_EQ(outcome.output, "") << all;
        EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << all << outcome.error;
        EXPECT_EQ(outcome.error.rfind("plateau: ", 0), 0u) << outcome.error;
        return outcome.error;
    }

    std::string sample_file(const char* shape, std::uint32_t size) const {
        const PointCloud cloud = sample_shape(shape, {.size = size}).value();
        return written(std::string(shape) + ".xyz", cloud_xyz(cloud, 0, size));
    }

private:
    std::string folder_;
};

inline bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace plateau
