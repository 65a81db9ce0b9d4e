// SPDX-License-Identifier: MIT
// Tests of spectra in separate files.
#include "import/described_material.hpp"
#include "import/load_scene.hpp"
#include "import/scene_file.hpp"

using namespace nicol;

namespace {

/// A scene file with eta.spd in the same folder.
struct WithFile : SceneFile {
    explicit WithFile(std::string_view spectrum, const std::string& attributes = "filename='eta.spd'")
        : SceneFile(::scene(shape_with("<bsdf type='conductor'>\n<spectrum name='eta' " + attributes +
                                       "/><spectrum name='k' value='400:3, 700:4'/></bsdf>"))) {
        write("eta.spd", spectrum);
    }
};

}  // namespace

TEST_CASE("a spectrum in a file is what it would be in the scene") {
    const WithFile file("# data\r\n# ;  Lambda  n\r\n\n 400 1.5 \n5.005e2\t1.25 # middle\n700 0.1");
    const SceneDescription read = read_mitsuba_scene(file.scene());
    const std::vector<ColorDescription::Sample> expected{{400, 1.5}, {500.5, 1.25}, {700, 0.1}};
    CHECK(as<MetalModel>(read.materials.at(0)).eta.spectrum == expected);
    REQUIRE(read.files.size() == 2);
    CHECK(read.files[1].path.filename() == "eta.spd");
    const LoadedScene loaded = load_scene(file.scene(), {});
    CHECK(loaded.scene.instances().at(0).material->channels() == 3);
    CHECK(loaded.files.size() == 2);
}

TEST_CASE("spectra in files are looked for in the folders of <path>, and read once each") {
    const SceneFile file(
        ::scene("<path value='spectra'/>" +
                shape_with("<bsdf type='conductor'><spectrum name='eta' filename='a.spd'/><spectrum "
                           "name='k' filename='a.spd'/></bsdf>")));
    std::filesystem::create_directory(file / "spectra");
    write_bytes(file / "spectra" / "a.spd", "400 1\n700 2\n");
    const SceneDescription read = read_mitsuba_scene(file.scene());
    const auto metal = as<MetalModel>(read.materials.at(0));
    CHECK(metal.eta == metal.k);
    CHECK(read.files.size() == 2);
}

TEST_CASE("spectra in files that are refused name the file and the line") {
    struct Case {
        const char* content;
        const char* message;
    };
    for (const auto& [content, message] :
         {Case{"400 1\n500\n", "eta.spd:2: expected a wavelength in nm and a value"},
          {"# n\n400 1 2\n", "eta.spd:2: expected"},
          {"400 1\n500 x\n", "eta.spd:2: expected"},
          {"400 1\n500 nan\n", "eta.spd:2: expected"},
          {"400 1\n\n400 2\n", "eta.spd:3: the wavelength is not above"},
          {"-1 1\n400 2\n", "eta.spd:1: the wavelength is not above"},
          {"400 1\n", "eta.spd: 1 wavelengths; expected two and more"},
          {"", "eta.spd: 0 wavelengths"}}) {
        CAPTURE(message);
        const WithFile file(content);
        const std::string error = error_of(CALL(read_mitsuba_scene(file.scene())), ErrorCode::invalid_file);
        CHECK(error.find(message) != std::string::npos);
    }
    check_refused(WithFile("400 1\n500 101\n"), ErrorCode::invalid_file, "", {"\"eta\"", "from 0 to 100"});
    check_refused(WithFile("", "filename='missing.spd'"), ErrorCode::file_not_found, "",
                  {"scene.xml:", "missing.spd", "no such file"});
    check_refused(WithFile("", "filename='eta.spd' value='1'"), ErrorCode::invalid_file, "", {"value"});
}
