// SPDX-License-Identifier: MIT
#include "upload.hpp"

#include <doctest/doctest.h>

#include "refused.hpp"

namespace {

constexpr const char* kType = "multipart/form-data; boundary=\"a b\"";

std::string part(const std::string& disposition, const std::string& content) {
    return "--a b\r\nContent-Disposition: form-data; " + disposition + "\r\n\r\n" + content + "\r\n";
}

}  // namespace

TEST_CASE("a body of one file is named by its type") {
    struct Case {
        const char* type;
        const char* name;
    };
    for (const Case& c :
         {Case{"model/gltf-binary", "scene.glb"}, Case{" Model/GLTF+JSON ; x=y", "scene.gltf"},
          Case{"text/xml; charset=utf-8", "scene.xml"}, Case{"application/octet-stream", "scene"}}) {
        const Upload upload = parse_upload(c.type, "content");
        REQUIRE(upload.files.size() == 1);
        CHECK(upload.files[0].name == c.name);
        CHECK(upload.files[0].bytes == "content");
    }
    CHECK(refused([] { parse_upload("text/plain", "content"); }).status == 415);
    CHECK(refused([] { parse_upload("", "content"); }).status == 415);
    CHECK(refused([] { parse_upload("text/xml", ""); }).status == 400);
}

TEST_CASE("parts are files by their names") {
    const std::string body = "preamble\r\n" + part("name=scene; filename=\"a/b.xml\"", "one\r\n--a c") +
                             part("name=\"c\\\"d;.obj\"", "") + "--a b--\r\nepilogue";
    const Upload upload = parse_upload(kType, body);
    REQUIRE(upload.files.size() == 2);
    CHECK(upload.files[0].name == "a/b.xml");
    CHECK(upload.files[0].bytes == "one\r\n--a c");
    CHECK(upload.files[1].name == "c\"d;.obj");
    CHECK(upload.files[1].bytes.empty());
    CHECK(upload.id.starts_with("upload-"));
    CHECK(parse_upload(kType, body).id == upload.id);
    CHECK(parse_upload(kType, part("name=a", "one") + "--a b--").id != upload.id);

    Upload again;
    const std::string packed = pack(upload);
    REQUIRE(unpack(packed, again));
    CHECK(pack(again) == packed);
    for (std::size_t size = 0; size < packed.size(); ++size)
        if (unpack(packed.substr(0, size), again)) CHECK(pack(again) == packed.substr(0, size));
}

TEST_CASE("every cut of a body is refused or whole") {
    const std::string body = part("name=a", "one") + part("name=b", "two") + "--a b--";
    CHECK(parse_upload(kType, body).files.size() == 2);
    for (std::size_t size = 0; size < body.size(); ++size) {
        const std::string cut = body.substr(0, size);
        CAPTURE(size);
        CHECK(refused([&] { parse_upload(kType, cut); }).status == 400);
    }
}

TEST_CASE("names stay in their folder") {
    for (const char* name : {"/a", "../a", "a/../b", "a//b", "./a", "a/.", "a/", "..", "", "a\tb", "a\x7f"}) {
        CAPTURE(std::string(name));
        CHECK(refused([&] {
                  parse_upload(kType, part("filename=\"" + std::string(name) + "\"", "x") + "--a b--");
              }).status == 400);
    }
    const std::string longest(255, 'a');
    CHECK(parse_upload(kType, part("name=" + longest, "x") + "--a b--").files[0].name == longest);
    CHECK(refused([&] { parse_upload(kType, part("name=a" + longest, "x") + "--a b--"); }).status == 400);
}

TEST_CASE("only the path of scenes takes them") {
    CHECK(sends_scene("POST /v1/scenes HTTP/1.1\r\n"));
    CHECK(sends_scene("POST /scenes?sig=0 HTTP/1.1\r\n"));
    CHECK(!sends_scene("GET /v1/scenes HTTP/1.1\r\n"));
    CHECK(!sends_scene("POST /v1/scenes/a HTTP/1.1\r\n"));
    CHECK(!sends_scene("POST"));
}
