// SPDX-License-Identifier: Apache-2.0
#include "importers/gltf/uris.h"

#include <gtest/gtest.h>

namespace alidade::gltf {
namespace {

std::string decoded(const std::string& uri) {
    const auto bytes = decode_data_uri(uri);
    return bytes ? std::string(bytes->begin(), bytes->end()) : "error: " + bytes.error();
}

/// The test vectors of RFC 4648, section 10; with and without padding, and with any media type.
TEST(DataUri, DecodesBase64) {
    EXPECT_EQ(decoded("data:application/octet-stream;base64,"), "");
    EXPECT_EQ(decoded("data:application/gltf-buffer;base64,Zg=="), "f");
    EXPECT_EQ(decoded("data:;base64,Zm8="), "fo");
    EXPECT_EQ(decoded("data:;base64,Zm8"), "fo");
    EXPECT_EQ(decoded("data:image/png;base64,Zm9vYmFy"), "foobar");
    EXPECT_EQ(decoded("data:;base64,_-4="), "\xff\xee");
}

TEST(DataUri, DecodesPercentText) { EXPECT_EQ(decoded("data:text/plain,a%20b%41"), "a bA"); }

TEST(DataUri, RefusesWhatIsNeither) {
    EXPECT_EQ(decoded("data:nothing"), "error: a data: URI needs a comma before its data");
    EXPECT_EQ(decoded("data:;base64,Zm9v!"), "error: byte 0x21 is not a base64 digit");
    EXPECT_EQ(decoded("data:;base64,Zm9vY"), "error: the base64 text ends inside a byte");
    EXPECT_EQ(decoded("data:,50%"), "error: a % must be followed by two hexadecimal digits");
    EXPECT_EQ(decoded("data:,50%4"), "error: a % must be followed by two hexadecimal digits");
}

TEST(ResolveUri, StaysBelowTheScene) {
    EXPECT_EQ(resolve_uri("a.bin", "/scenes").value(), "/scenes/a.bin");
    EXPECT_EQ(resolve_uri("textures/a%20b.png", "/scenes").value(), "/scenes/textures/a b.png");
    EXPECT_EQ(resolve_uri("./a.bin", "/scenes").value(), "/scenes/a.bin");
    EXPECT_EQ(resolve_uri("textures\\a.png", "/scenes").value(), "/scenes/textures/a.png");
    EXPECT_EQ(resolve_uri("..a/b..c", "/scenes").value(), "/scenes/..a/b..c");
}

TEST(ResolveUri, RefusesEveryWayOut) {
    for (const char* uri : {"/etc/passwd", "../a.bin", "a/../../b", "a/..", "%2e%2e/a", "..%2fa", "%2fetc/passwd", "\\\\server\\share", "..\\a",
                            "C:\\a", "C%3A/a", "file:///etc/passwd", "http://host/a", "https://host/a", "a%00b", "%00", "", "%", "%zz"}) {
        EXPECT_FALSE(resolve_uri(uri, "/scenes")) << uri;
    }
    EXPECT_FALSE(resolve_uri("a.bin", "")) << "no base directory: no file";
}

}  // namespace
}  // namespace alidade::gltf
