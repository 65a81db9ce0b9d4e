// SPDX-License-Identifier: MIT
#include "scene_file.hpp"

#include <fstream>
#include <stdexcept>

void write_scene(const std::filesystem::path& path, const std::string& origin, const std::string& target,
                 const std::string& content, const std::string& up) {
    std::ofstream out(path);
    out << R"(<scene version="3.0.0"><sensor type="perspective"><float name="fov" value="40"/>)"
        << R"(<transform name="to_world"><lookat origin=")" << origin << R"(" target=")" << target
        << R"(" up=")" << up << R"("/></transform></sensor>)" << content << "</scene>";
    if (!out.flush()) throw std::runtime_error(path.string() + ": cannot be written");
}
