// Every format of input, through the built command: the way in does not change the run.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "cloud_files.h"

namespace plateau {
namespace {

/// What the command prints, both streams together; the exit code must be 0.
std::string output_of(const std::string& command) {
    std::FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    std::string output;
    char block[4096];
    while (const std::size_t got = std::fread(block, 1, sizeof block, pipe)) output.append(block, got);
    const int status = pclose(pipe);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << output;
    return output;
}

TEST(Formats, EveryFormatGivesTheSameHashByFileAndFromStandardInput) {
    // tests/web/formats.spec.ts expects the same of the page.
    const std::string hash = "hash b02b080a890c8b85\n";
    const std::string run = std::string(PLATEAU_BINARY) + " run ";
    std::string folder = testing::TempDir() + "plateau-formats-XXXXXX";
    ASSERT_NE(mkdtemp(folder.data()), nullptr);
    for (const CloudFormat& format : cloud_formats()) {
        SCOPED_TRACE(format.name);
        const std::string path = folder + "/cloud." + format.extension;
        std::ofstream(path, std::ios::binary) << format.write(scattered_points(150));
        EXPECT_EQ(output_of(run + path + " --betti /dev/null --hash"), hash);
        EXPECT_EQ(output_of(run + "- --betti /dev/null --hash < " + path), hash);
        // A name that says nothing.
        const std::string renamed = folder + "/cloud.dat";
        ASSERT_EQ(std::rename(path.c_str(), renamed.c_str()), 0);
        EXPECT_EQ(output_of(run + renamed + " --betti /dev/null --hash"), hash);
    }
    EXPECT_EQ(std::system(("rm -r " + folder).c_str()), 0);
}

}  // namespace
}  // namespace plateau
