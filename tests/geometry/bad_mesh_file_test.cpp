// SPDX-License-Identifier: MIT
// Tests of mesh files that must be refused, and of the error messages.
#include <sys/stat.h>

#include "geometry/mesh.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using nicol::ErrorCode;
using nicol::load_mesh;

namespace {

/// Checks that loading fails with `code` and that the message names the file and contains `part`.
void check_refused(const std::string& name, const std::string& bytes, ErrorCode code,
                   const std::string& part) {
    CAPTURES(name, bytes.substr(0, 200));
    const TemporaryFolder folder;
    const auto file = folder.write(name, bytes);
    const std::string message = error_of(CALL(load_mesh(file)), code);
    CAPTURE(message);
    CHECK(message.starts_with(file.string()));
    CHECK(message.find(part) != std::string::npos);
}

void invalid(const std::string& name, const std::string& bytes, const std::string& part) {
    check_refused(name, bytes, ErrorCode::invalid_file, part);
}

const std::string ply_vertices = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string ply_faces = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string ply_header = "ply\nformat ascii 1.0\n" + ply_vertices + ply_faces + "end_header\n";
const std::string obj_points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\n";

}  // namespace

TEST_CASE("files that are not there or of no known kind") {
    const TemporaryFolder folder;
    REQUIRE(mkfifo((folder.path() / "pipe.stl").c_str(), 0600) == 0);  // opening would block
    for (const auto& file : {folder.path() / "absent.obj", folder.path() / "folder.ply",
                             folder.path() / "pipe.stl", std::filesystem::path("/dev/zero.stl")}) {
        if (file.stem() == "folder") std::filesystem::create_directory(file);
        check_error(ErrorCode::file_not_found, CALL(load_mesh(file)));
    }
    for (const char* name : {"mesh.fbx", "mesh", "mesh.obj.gz"})
        check_refused(name, obj_points, ErrorCode::unsupported, ".obj, .ply, .off, .stl or .serialized");
}

TEST_CASE("empty files and garbage of every suffix") {
    std::mt19937 random(7);
    for (const std::string suffix : {".obj", ".ply", ".off", ".stl"}) {
        check_refused("empty" + suffix, "", ErrorCode::invalid_file, "");
        for (int i = 0; i < 50; ++i) {
            std::string bytes(1 + random() % 400, '\0');
            for (char& c : bytes) c = static_cast<char>(random());
            check_refused("garbage" + suffix, bytes, ErrorCode::invalid_file, "");
        }
    }
}

TEST_CASE("a comma before decimals is an error with its line, not a zero") {
    const std::string face = "f 1 2 3\n";
    invalid("a.obj", "v 0,5 0,25 0\n" + obj_points + face, ":1: vertex x is \"0,5\"");
    invalid("a.obj", obj_points + "v 0 0 0 0,5 0,5 0,5\n" + face, ":5: a colour is \"0,5\"");
    invalid("a.obj", obj_points + "vt 0.5 0,5\n" + face, ":5: texture v is \"0,5\"");
    invalid("a.obj", obj_points + "vn 0 0,6 0.8\n" + face, ":5: normal y is \"0,6\"");
    invalid("a.obj", obj_points + "f 1,2,3\n", ":5: corner 0");
    invalid("a.off", "OFF\n3 1 0\n0 0 0\n1,5 0 0\n0 1 0\n3 0 1 2\n", ":4: ");
    invalid("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 0,5 0,2 0,1\n", ":6: ");
    invalid("a.ply", ply_header + "0 0 0\n1,5 0 0\n0 1 0\n3 0 1 2\n", ":11: ");
    invalid("a.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0,5 0\n", ":4: ");
    // A comma after a complete number is not part of the number.
    check_refused("a.obj", "v 0, 0, 0\nv 1, 0, 0\nv 2, 0, 0\n", ErrorCode::invalid_file, "no faces");
}

TEST_CASE("faults of OBJ files, with their line") {
    invalid("a.obj", obj_points, "no faces");
    invalid("a.obj", "f 1 2 3\n", ":1: a face uses vertex 3 (1-based), but the file has 0");
    invalid("a.obj", obj_points + "f 1 2 5\n", ":5: a face uses vertex 5 (1-based), but the file has 4");
    invalid("a.obj", obj_points + "f 1//1 2//1 3//1\n", ":5: a face uses normal 1");
    invalid("a.obj", obj_points + "f 1 2 0\n", ":5: corner 2");
    invalid("a.obj", obj_points + "f 1 2 -5\n", ":5: corner 2");
    invalid("a.obj", obj_points + "f 1 2 99999999999999999999\n", ":5: corner 2");
    invalid("a.obj", obj_points + "f //1 2 3\n", ":5: corner 0");
    invalid("a.obj", obj_points + "f 1 2 3x\n", ":5: corner 2");
    invalid("a.obj", obj_points + "f\n", ":5: a face with no corners");
    invalid("a.obj", obj_points + "f 1 2 2\nf 1 2 4\n", "none of its 2 faces has an area");
    invalid("a.obj", "v 0 0\n", ":1: the file ends where vertex z");
    invalid("a.obj", "v 0 0 zero\n", ":1: vertex z is \"zero\"");
    invalid("a.obj", "\nv 0 nan 0\n", ":2: vertex y is \"nan\"");
    invalid("a.obj", "v 0 0 1e39\n", ":1: vertex z");
    invalid("a.obj", "v 0 0 1e999\n", ":1: vertex z");
    invalid("a.obj", "v 0 0 inf\n", ":1: vertex z");
    invalid("a.obj", obj_points + "vn 0 0\nf 1 2 3\n", ":5: ");
    for (const std::string mark : {"\xFE\xFF", "\xFF\xFE"})
        check_refused("a.obj", mark + obj_points, ErrorCode::unsupported, "UTF-16");
    invalid("a.obj", obj_points + "hello\n", ":5: ");
    check_refused("a.obj", "cstype bezier\n", ErrorCode::unsupported, ":1: free-form");
}

TEST_CASE("faults of PLY files") {
    invalid("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\n", ":4: the file ends before \"end_header\"");
    invalid("a.ply", "ply\nproperty float x\n", ":2: a property before the first element");
    invalid("a.ply", "ply\nformat ascii_2 1.0\n", ":2: unknown format");
    invalid("a.ply", "ply\nformat ascii 1.0\nelement vertex -1\n", ":3: ");
    invalid("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty half x\n", ":4: not a PLY type");
    invalid("a.ply", "ply\nformat ascii 1.0\nelement face 3\nproperty list float int vertex_indices\n",
            ":4: the length");
    invalid("a.ply", "ply\nformat ascii 1.0\nend_header\n", "expected one element \"vertex\"");
    invalid("a.ply", "ply\n" + ply_vertices + ply_faces + "end_header\n", "no \"format\" line");
    invalid("a.ply",
            "ply\nformat ascii 1.0\n" + ply_vertices +
                "element face 1\nproperty int i\nend_header\n0 0 0 1 0 0 0 1 0 1\n",
            "no list vertex_indices");
    invalid("a.ply",
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n" + ply_faces + "end_header\n0\n",
            "no property y");
    invalid(
        "a.ply",
        "ply\nformat ascii 1.0\n" + ply_faces + ply_vertices + "end_header\n3 0 1 3\n0 0 0\n1 0 0\n0 1 0\n",
        "face 0 (0-based) uses vertex 3");
    invalid("a.ply", ply_header + "0 0 0\n1 0 0\n0 1\n", ":13: the file ends where vertex 2 (0-based)");
    invalid("a.ply", ply_header + "0 0 0\n1 0 0\n0 1 x\n3 0 1 2\n", ":12: vertex 2 (0-based) is \"x\"");
    invalid("a.ply", ply_header + "0 0 0\n1 0 0\n0 1 nan\n3 0 1 2\n", ":12: ");
    invalid("a.ply", ply_header + "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "face 0 (0-based) uses vertex 3");
    invalid("a.ply", ply_header + "0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", ":13: face 0 (0-based) is \"-1\"");
    invalid("a.ply", ply_header + "0 0 0\n1 0 0\n0 1 0\n2 0 1\n", "no faces");
    invalid("a.ply", ply_header + "0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n", "none of its 1 faces has an area");
}

TEST_CASE("hostile PLY headers cost neither memory nor time") {
    const auto claims = [](const std::string& format, const std::string& vertices, const std::string& faces) {
        return "ply\nformat " + format + " 1.0\nelement vertex " + vertices +
               "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
               "\nproperty list uint int vertex_indices\nend_header\n";
    };
    const std::string zeros(36, '\0');
    const std::string huge_list("\xff\xff\xff\xff", 4);
    for (const std::string format : {"ascii", "binary_little_endian", "binary_big_endian"})
        for (const std::string count : {"2147483648", "4294967295", "18446744073709551615"}) {
            check_refused("a.ply", claims(format, count, "1"), ErrorCode::invalid_file, "ends w");
            check_refused("a.ply",
                          claims(format, "3", count) + (format == "ascii" ? "0 0 0 1 0 0 0 1 0" : zeros),
                          ErrorCode::invalid_file, "ends w");
        }
    check_refused("a.ply", claims("ascii", "18446744073709551616", "1"), ErrorCode::invalid_file, ":3: ");
    check_refused("a.ply", claims("binary_little_endian", "3", "1") + zeros + huge_list,
                  ErrorCode::invalid_file, "ends within face 0");
    check_refused("a.ply", claims("ascii", "3", "1") + "0 0 0 1 0 0 0 1 0 4294967295 0 1 2\n",
                  ErrorCode::invalid_file, "ends where face 0");
    // An element without properties takes no bytes, whatever its count.
    check_refused("a.ply",
                  "ply\nformat ascii 1.0\nelement nothing 18446744073709551615\n" + ply_vertices + ply_faces +
                      "end_header\n0 0 0\n1 0 0\n0 1 0\n",
                  ErrorCode::invalid_file, "ends where face 0");
}

TEST_CASE("faults of OFF files") {
    invalid("a.off", "3 1 0\n", "not an OFF file");
    invalid("a.off", "OFF\n3\n", "the file ends where the number of faces");
    invalid("a.off", "OFF\n3 x 0\n", ":2: the number of faces is \"x\"");
    invalid("a.off", "OFF\n4000000000 1 0\n0 0 0\n", "vertex 1 (0-based)");
    invalid("a.off", "OFF\n3 4000000000 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "face 1 (0-based)");
    invalid("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n", "face 0 (0-based)");
    invalid("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", ":6: face 0 (0-based) uses vertex 3");
    invalid("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n1 0\n", "no faces");
    invalid("a.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", "no faces");
    check_refused("a.off", "4OFF\n", ErrorCode::unsupported, "three coordinates");
    check_refused("a.off", "OFF BINARY\n", ErrorCode::unsupported, "binary OFF");
}

TEST_CASE("faults of STL files") {
    const std::string begin = "solid\nfacet normal 0 0 1\nouter loop\n";
    const std::string end = "endloop\nendfacet\nendsolid\n";
    invalid("a.stl", "solid\nendsolid\n", "no faces");
    invalid("a.stl", "solid\n", "the file ends where facet or endsolid");
    invalid("a.stl", "solid\nfacets\n", ":2: expected \"facet\"");
    invalid("a.stl", begin + "vertex 0 0 0\nvertex 1 0 0\n" + end, ":6: expected \"vertex\"");
    invalid("a.stl", begin + "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 nan\n" + end,
            ":6: a coordinate of facet 0 (0-based)");
    invalid("a.stl", begin + "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n", "the file ends where endloop");
    invalid("a.stl", begin + "vertex 0 0 0\nvertex 1 0 0\nvertex 1 0 0\n" + end, "no faces");
    invalid("a.stl", begin + "vertex 0 0 0\nvertex 1 0 0\nvertex 2 0 0\n" + end,
            "none of its 1 faces has an area");
    std::string claims(84, '\0');
    claims[83] = '\x7f';
    invalid("a.stl", claims, "the file has 84");
    claims.assign(80, '\0');
    claims += std::string("\1\0\0\0", 4) + std::string(12, '\0');
    for (int i = 0; i < 9; ++i) claims += std::string("\0\0\xc0\x7f", 4);
    invalid("a.stl", claims + std::string(2, '\0'), "facet 0 (0-based) has a corner that is not finite");
}

TEST_CASE("a file cut short anywhere or with a byte changed never does worse than fail") {
    const TemporaryFolder folder;
    std::string binary = "ply\nformat binary_little_endian 1.0\n" + ply_vertices +
                         "element face 1\nproperty list int int vertex_indices\nend_header\n";
    const float points[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const int face[4] = {3, 0, 1, 2};
    binary.append(reinterpret_cast<const char*>(points), sizeof(points));
    binary.append(reinterpret_cast<const char*>(face), sizeof(face));
    const std::vector<std::pair<std::string, std::string>> files = {
        {"a.obj", obj_points + "vn 0 0 1\nf 1//1 2//1 3//1\n"},
        {"a.ply", ply_header + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
        {"b.ply", binary},
        {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
        {"a.stl",
         "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
         "0\nendloop\nendfacet\nendsolid\n"}};
    std::mt19937 random(11);
    int failures = 0;
    const auto attempt = [&](const std::string& name, const std::string& bytes) {
        try {
            static_cast<void>(load_mesh(folder.write(name, bytes)));
        } catch (const nicol::Error& e) {
            CHECK(e.code() != ErrorCode::internal);
            ++failures;
        }
    };
    for (const auto& [name, bytes] : files) {
        CAPTURE(name);
        CHECK_NOTHROW(static_cast<void>(load_mesh(folder.write(name, bytes))));
        for (std::size_t size = 0; size < bytes.size(); ++size) attempt(name, bytes.substr(0, size));
        for (int i = 0; i < 400; ++i) {
            std::string changed = bytes;
            changed[random() % changed.size()] = static_cast<char>(random());
            attempt(name, changed);
        }
    }
    CHECK(failures > 1000);
}
