// SPDX-License-Identifier: MIT
#include "options.hpp"

#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string_view>

#include "common/number_list.hpp"

const char* const usage =
    "usage: nicol-render SCENE -o OUT.exr [options]\n"
    "Renders a scene, Mitsuba 3's .xml or glTF's .gltf or .glb, to a Stokes image: channels R G B and S0.R "
    "... "
    "S3.B.\n"
    "\n"
    "  -o, --output FILE        the OpenEXR image to write; -: to the standard output\n"
    "  -D, --define NAME=VALUE  replaces the value of a <default> of the scene; may be repeated\n"
    "      --time SECONDS       the time of a glTF file's animation; without it nothing is animated\n"
    "      --animation NAME     name or number of that animation; default the first\n"
    "      --shutter OPEN,CLOSE[,COUNT]   motion blur in place of --time: the mean of COUNT pictures (16) "
    "between\n"
    "                           these times in seconds\n"
    "      --environment FILE   an environment map that lights the scene, in place of the scene's own\n"
    "      --rotate-environment DEGREES  rotates it about the world's y, counter-clockwise seen from above\n"
    "      --look-at X,Y,Z,X,Y,Z[,FOV]   a camera at the first point that looks at the second; field of "
    "view\n"
    "                           in degrees, default that of the scene's camera\n"
    "      --exposure STOPS     of the s0.png and polarizer_*.png of --images; default 0\n"
    "      --images DIR       also writes s0, s1, s2, s3, dolp and aolp.png into DIR, made when missing\n"
    "      --polarizers A,... also writes polarizer_A.png, ... into DIR: light behind a polarizer, degrees\n"
    "      --mosaic FILE        also writes what an image sensor gives for the image, as a grey PNG\n"
    "      --sensor FILE        that sensor, as JSON; default: polarizers on the pixels and a little noise\n"
    "      --frame N            gives other noise of the sensor; default 0\n"
    "      --backend NAME       egl or osmesa; without it NICOL_BACKEND decides, else the first that works\n"
    "      --device N           the device to use, of those that --list-devices shows\n"
    "      --list-devices       shows the devices that OpenGL can be opened on\n"
    "      --aovs NAMES         also writes AOVs of the surfaces: depth, normals, positions, ids, alpha; by "
    "the\n"
    "                           reference method the variance of the image; commas between several\n"
    "      --method NAME        factored or dense, in real time, or reference, by rays: slow and noisy\n"
    "      --executor NAME      where relight and shade run: cpu (threads), compute (shaders) or automatic,\n"
    "                           which is compute where OpenGL does not run on the CPU; default automatic\n"
    "      --order-low N        order of the light taken with its full angular detail, 0 to 32;\n"
    "                           default: see --tolerance\n"
    "      --order-high N       order of the light taken at all, --order-low to 64; default: see\n"
    "                           --tolerance\n"
    "      --high-orders NAME   how orders above --order-low are taken: split, convolution or none;\n"
    "                           default split\n"
    "      --shade-at NAME      where light becomes a Stokes vector: vertices, pixels (for coarse meshes)\n"
    "                           or automatic, by the predicted error; default automatic\n"
    "      --quality NAME       what the image is for: realtime (1 sample of a pixel), preview (8) or final "
    "(64, a\n"
    "                           tolerance of 0.01); other options win\n"
    "      --pixel-samples N    samples of a pixel by the methods in real time, 1 to 1024, against jagged\n"
    "                           outlines and for soft shadows; default: by --quality, without it the\n"
    "                           sample_count of the scene's sampler, at most 64; 8 without a sampler\n"
    "      --filter NAME        how samples around a pixel are weighed: box, gaussian, tent, mitchell, "
    "catmullrom or\n"
    "                           lanczos; default: the rfilter of the scene's film, of glTF box\n"
    "      --tolerance E        where no order is given, orders are chosen for which the predicted relative\n"
    "                           RMSE of s0, s1 and s2 is at most E, or little above the\n"
    "                           least one if none are; default 0.03\n"
    "      --components NAME    what the image holds: s0, linear (s0, s1, s2) or all; default all\n"
    "      --no-shadows         computes no shadows\n"
    "      --bake-directions N  directions that shadows are traced in from each vertex, 256 to 65536;\n"
    "                           default: as the tolerance or the orders need\n"
    "      --refine-tolerance E triangles are split where interpolated shadows err by more than this part "
    "of\n"
    "                           the light; 0: none is split, 0.01 to 0.1 are of use; default 0.02\n"
    "      --max-vertices N     that splitting may lead to; default 65536, or four times the scene's\n"
    "      --dering X           weakens high orders of the light against ringing; default 0, 0.001 helps\n"
    "      --no-physical        leaves s0 < 0 and DoLP > 1, which truncation may cause, as they are\n"
    "      --split-lights N     bright parts of the environment rendered as local lights, at most, 0 to 64;\n"
    "                           default: those that the orders would miss\n"
    "      --light-samples N    samples of a light with a size that light each point, 1 to 1024; default "
    "16,\n"
    "                           up to twice as many for very wide lights\n"
    "      --bsdf-samples N     most samples of the environment for each anisotropic or narrow lobe, 0 to "
    "1024; default 32\n"
    "      --samples N          of the reference method, camera rays a pixel, 1 to 1048576; default 256\n"
    "      --max-depth N        how often light is reflected, counted as in "
    "Mitsuba: 2 is\n"
    "                           direct light, -1 no limit; default: that of the scene's integrator, else 2\n"
    "      --seed N             of the reference method, gives other noise; default 0\n"
    "      --cache DIR          keeps tables of materials and bakes of shadows there between runs;\n"
    "                           default: NICOL_CACHE, where empty none, else the user's cache folder\n"
    "      --load-bytes-limit N, --vertex-limit N, --triangle-limit N, --load-seconds-limit S\n"
    "                           what a scene may take, with all that it names and each instance counted;\n"
    "                           default 8 GiB, 2^26, 2^27 and 600\n"
    "      --size WxH           replaces the size of the scene's film\n"
    "      --frame-all          moves the camera, without turning it, so that the whole scene is in the "
    "image\n"
    "      --stats FILE         writes what ran, and how long it took, as JSON; -: to the standard output\n"
    "      --help               shows this text\n"
    "      --version            shows the version and what this build has\n"
    "\n"
    "Exit code 0, or 2 and a one-line message on the standard error.\n";

namespace {

template <class Number = std::uint32_t>
Number parse_number(std::string_view option, std::string_view text) {
    Number value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
        throw Failure(std::string(option) + ": '" + std::string(text) +
                      "' is not a whole number of at most " +
                      std::to_string(std::numeric_limits<Number>::max()));
    return value;
}

std::uint32_t parse_count(std::string_view option, std::string_view text, std::uint32_t least,
                          std::uint32_t most) {
    const std::uint32_t count = parse_number(option, text);
    if (count < least || count > most)
        throw Failure(std::string(option) + ": " + std::string(text) + " does not lie in " +
                      std::to_string(least) + " to " + std::to_string(most));
    return count;
}

double parse_one(std::string_view option, std::string_view text) {
    const std::vector<double> values = parse_list(option, text);
    if (values.size() != 1)
        throw Failure(std::string(option) + ": '" + std::string(text) + "' must be one number");
    return values[0];
}

std::vector<double> parse_look_at(std::string_view text) {
    std::vector<double> values = parse_list("--look-at", text);
    if (values.size() != 6 && values.size() != 7)
        throw Failure("--look-at: '" + std::string(text) + "' has " + std::to_string(values.size()) +
                      " numbers; it must be X,Y,Z,X,Y,Z or X,Y,Z,X,Y,Z,FOV");
    return values;
}

double parse_strength(std::string_view option, std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !(value >= 0) || !std::isfinite(value))
        throw Failure(std::string(option) + ": '" + std::string(text) + "' is not a number of at least 0");
    return value;
}

std::int32_t parse_depth(std::string_view text) {
    const std::int32_t depth =
        text == "-1" ? NICOL_DEPTH_UNLIMITED : parse_number<std::int32_t>("--max-depth", text);
    if (depth == 0 || depth < NICOL_DEPTH_UNLIMITED)
        throw Failure("--max-depth: " + std::string(text) + " is neither 1 or more nor -1, no limit");
    return depth;
}

void parse_size(Options& options, std::string_view text) {
    const std::size_t cross = text.find('x');
    if (cross == std::string_view::npos)
        throw Failure("--size: '" + std::string(text) + "' is not WIDTHxHEIGHT, like 640x480");
    options.width = parse_number("--size", text.substr(0, cross));
    options.height = parse_number("--size", text.substr(cross + 1));
}

nicol_backend parse_backend(std::string_view text) {
    if (text == "egl") return NICOL_BACKEND_EGL;
    if (text == "osmesa") return NICOL_BACKEND_OSMESA;
    throw Failure("--backend: '" + std::string(text) + "' is neither egl nor osmesa");
}

std::uint32_t parse_aovs(std::string_view text) {
    std::uint32_t aovs = 0;
    for (bool more = true; more;) {
        const std::size_t comma = text.find(',');
        const std::string_view name = text.substr(0, comma);
        if (name == "depth")
            aovs |= NICOL_AOV_DEPTH;
        else if (name == "normals")
            aovs |= NICOL_AOV_NORMAL;
        else if (name == "positions")
            aovs |= NICOL_AOV_POSITION;
        else if (name == "ids")
            aovs |= NICOL_AOV_INSTANCE;
        else if (name == "alpha")
            aovs |= NICOL_AOV_ALPHA;
        else if (name == "variance")
            aovs |= NICOL_AOV_VARIANCE;
        else
            throw Failure("--aovs: '" + std::string(name) +
                          "' is none of: depth, normals, positions, ids, alpha, variance");
        more = comma != std::string_view::npos;
        if (more) text.remove_prefix(comma + 1);
    }
    return aovs;
}

nicol_method parse_method(std::string_view text) {
    if (text == "factored") return NICOL_METHOD_FACTORED;
    if (text == "dense") return NICOL_METHOD_DENSE;
    if (text == "reference") return NICOL_METHOD_REFERENCE;
    throw Failure("--method: '" + std::string(text) +
                  "' is not a method of this version, which has: factored, dense, reference");
}

nicol_executor parse_executor(std::string_view text) {
    if (text == "automatic") return NICOL_EXECUTOR_AUTOMATIC;
    if (text == "cpu") return NICOL_EXECUTOR_CPU;
    if (text == "compute") return NICOL_EXECUTOR_COMPUTE;
    throw Failure("--executor: '" + std::string(text) + "' is none of: automatic, cpu, compute");
}

nicol_high_orders parse_high_orders(std::string_view text) {
    if (text == "split") return NICOL_HIGH_ORDERS_SPLIT;
    if (text == "convolution") return NICOL_HIGH_ORDERS_CONVOLUTION;
    if (text == "none") return NICOL_HIGH_ORDERS_NONE;
    throw Failure("--high-orders: '" + std::string(text) + "' is none of: split, convolution, none");
}

nicol_shade_at parse_shade_at(std::string_view text) {
    if (text == "automatic") return NICOL_SHADE_AT_AUTOMATIC;
    if (text == "vertices") return NICOL_SHADE_AT_VERTICES;
    if (text == "pixels") return NICOL_SHADE_AT_PIXELS;
    throw Failure("--shade-at: '" + std::string(text) + "' is none of: automatic, vertices, pixels");
}

nicol_quality parse_quality(std::string_view text) {
    if (text == "realtime") return NICOL_QUALITY_REALTIME;
    if (text == "preview") return NICOL_QUALITY_PREVIEW;
    if (text == "final") return NICOL_QUALITY_FINAL;
    throw Failure("--quality: '" + std::string(text) + "' is none of: realtime, preview, final");
}

nicol_filter_kind parse_filter(std::string_view text) {
    if (text == "box") return NICOL_FILTER_BOX;
    if (text == "gaussian") return NICOL_FILTER_GAUSSIAN;
    if (text == "tent") return NICOL_FILTER_TENT;
    if (text == "mitchell") return NICOL_FILTER_MITCHELL;
    if (text == "catmullrom") return NICOL_FILTER_CATMULLROM;
    if (text == "lanczos") return NICOL_FILTER_LANCZOS;
    throw Failure("--filter: '" + std::string(text) +
                  "' is none of: box, gaussian, tent, mitchell, catmullrom, lanczos");
}

nicol_components parse_components(std::string_view text) {
    if (text == "all") return NICOL_COMPONENTS_ALL;
    if (text == "s0") return NICOL_COMPONENTS_S0;
    if (text == "linear") return NICOL_COMPONENTS_LINEAR;
    throw Failure("--components: '" + std::string(text) + "' is none of: s0, linear, all");
}

Options::Shutter parse_shutter(std::string_view text) {
    const std::vector<double> numbers = parse_list("--shutter", text);
    if (numbers.size() != 2 && numbers.size() != 3)
        throw Failure("--shutter: '" + std::string(text) + "' is not OPEN,CLOSE or OPEN,CLOSE,COUNT");
    Options::Shutter shutter{.open = numbers[0], .close = numbers[1]};
    if (!(shutter.close >= shutter.open))
        throw Failure("--shutter: '" + std::string(text) + "' closes before it opens");
    if (numbers.size() == 3) {
        if (!(numbers[2] >= 1 && numbers[2] <= 65536) || numbers[2] != std::floor(numbers[2]))
            throw Failure("--shutter: '" + std::string(text) + "' has a COUNT that is not in 1 to 65536");
        shutter.samples = static_cast<std::uint32_t>(numbers[2]);
    }
    return shutter;
}

std::string parse_definition(std::string_view text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos || equals == 0)
        throw Failure("-D: '" + std::string(text) + "' is not NAME=VALUE");
    return std::string(text);
}

}  // namespace

Options parse_options(int argc, const char* const* argv) {
    Options options;
    for (int i = 1; i < argc; ++i) {
        std::string_view name = argv[i];
        std::optional<std::string_view> attached;  // value in --name=value and -Dname=value
        if (name.starts_with("--") && name.find('=') != std::string_view::npos) {
            attached = name.substr(name.find('=') + 1);
            name = name.substr(0, name.find('='));
        } else if (name.starts_with("-D") && name.size() > 2) {
            attached = name.substr(2);
            name = "-D";
        }
        const auto value = [&]() -> std::string_view {
            if (attached) return *attached;
            if (i + 1 >= argc) throw Failure(std::string(name) + ": a value must follow");
            return argv[++i];
        };
        const auto path = [&]() -> std::string {
            std::string text(value());
            if (text.empty()) throw Failure(std::string(name) + ": the path is empty");
            return text;
        };
        if (name == "--help" || name == "-h")
            options.action = Options::Action::help;
        else if (name == "--version")
            options.action = Options::Action::version;
        else if (name == "--list-devices" && !attached)
            options.action = Options::Action::list_devices;
        else if (name == "-o" || name == "--output")
            options.output = path();
        else if (name == "-D" || name == "--define")
            options.definitions.push_back(parse_definition(value()));
        else if (name == "--time" || name == "--animation")
            options.definitions.push_back(std::string(name.substr(2)) + "=" + std::string(value()));
        else if (name == "--shutter")
            options.shutter = parse_shutter(value());
        else if (name == "--environment")
            options.environment = path();
        else if (name == "--rotate-environment")
            options.rotate_environment = parse_one(name, value());
        else if (name == "--look-at")
            options.look_at = parse_look_at(value());
        else if (name == "--exposure")
            options.exposure = parse_one(name, value());
        else if (name == "--images")
            options.images = path();
        else if (name == "--polarizers")
            options.polarizers = parse_list(name, value());
        else if (name == "--mosaic")
            options.mosaic = path();
        else if (name == "--sensor")
            options.sensor = path();
        else if (name == "--frame")
            options.frame = parse_number<std::uint64_t>(name, value());
        else if (name == "--backend")
            options.backend = parse_backend(value());
        else if (name == "--device")
            options.device = parse_count(name, value(), 1, 1024);
        else if (name == "--aovs")
            options.aovs = parse_aovs(value());
        else if (name == "--method")
            options.method = parse_method(value());
        else if (name == "--executor")
            options.executor = parse_executor(value());
        else if (name == "--order-low")
            options.order_low = parse_number(name, value());
        else if (name == "--order-high")
            options.order_high = parse_number(name, value());
        else if (name == "--high-orders")
            options.high_orders = parse_high_orders(value());
        else if (name == "--shade-at")
            options.shade_at = parse_shade_at(value());
        else if (name == "--quality")
            options.quality = parse_quality(value());
        else if (name == "--pixel-samples")
            options.pixel_samples = parse_count(name, value(), 1, 1024);
        else if (name == "--filter")
            options.filter = parse_filter(value());
        else if (name == "--tolerance")
            options.tolerance = parse_strength(name, value());
        else if (name == "--components")
            options.components = parse_components(value());
        else if (name == "--no-shadows" && !attached)
            options.shadows = false;
        else if (name == "--bake-directions")
            options.bake_directions = parse_count(name, value(), 256, 65536);
        else if (name == "--refine-tolerance")
            options.refine_tolerance = parse_strength(name, value());
        else if (name == "--max-vertices")
            options.max_vertices = parse_number(name, value());
        else if (name == "--dering")
            options.dering = parse_strength(name, value());
        else if (name == "--no-physical" && !attached)
            options.physical = false;
        else if (name == "--split-lights")
            options.split_lights =
                static_cast<std::int32_t>(parse_count(name, value(), 0, NICOL_MAX_SPLIT_LIGHTS));
        else if (name == "--light-samples")
            options.light_samples = parse_count(name, value(), 1, 1024);
        else if (name == "--bsdf-samples")
            options.bsdf_samples = parse_count(name, value(), 0, 1024);
        else if (name == "--samples")
            options.samples = parse_count(name, value(), 1, 1048576);
        else if (name == "--max-depth")
            options.max_depth = parse_depth(value());
        else if (name == "--seed")
            options.seed = parse_number<std::uint64_t>(name, value());
        else if (name == "--cache")
            options.cache = path();
        else if (name == "--load-bytes-limit")
            options.load_limits.load_bytes_limit = parse_number<std::uint64_t>(name, value());
        else if (name == "--vertex-limit")
            options.load_limits.vertex_limit = parse_number<std::uint64_t>(name, value());
        else if (name == "--triangle-limit")
            options.load_limits.triangle_limit = parse_number<std::uint64_t>(name, value());
        else if (name == "--load-seconds-limit")
            options.load_limits.load_seconds_limit = parse_strength(name, value());
        else if (name == "--size")
            parse_size(options, value());
        else if (name == "--frame-all" && !attached)
            options.frame_all = true;
        else if (name == "--stats")
            options.stats = path();
        else if (name.starts_with("-"))
            throw Failure("unknown option '" + std::string(argv[i]) + "'; --help lists them all");
        else if (!options.scene.empty())
            throw Failure("two scenes given, '" + options.scene + "' and '" + std::string(name) +
                          "'; one is wanted");
        else
            options.scene = name;
        if (options.action != Options::Action::render) return options;
    }
    if (options.scene.empty()) throw Failure("no scene given; usage: nicol-render SCENE -o OUT.exr");
    if (options.output.empty()) throw Failure("no output given; add -o OUT.exr");
    const std::string suffix = std::filesystem::path(options.output).extension().string();
    if (!suffix.empty() && suffix != ".exr" && suffix != ".EXR")
        throw Failure("--output " + options.output +
                      ": what is written is OpenEXR; the name must end in .exr (--images writes PNG)");
    if (options.images.empty() && !options.polarizers.empty())
        throw Failure("--polarizers: add --images DIR, where its images are written");
    if (options.shutter) {
        for (const std::string& definition : options.definitions)
            if (definition.starts_with("time="))
                throw Failure("--shutter and a time are both given; one of them says what is drawn");
        char text[32];
        const auto end = std::to_chars(text, text + sizeof text, options.shutter->time_of(0)).ptr;
        options.definitions.push_back("time=" + std::string(text, end));
    }
    if (options.mosaic.empty() && !options.sensor.empty())
        throw Failure("--sensor: add --mosaic OUT.png, where its raw image is written");
    if (options.output == kStandardOutput && options.stats == kStandardOutput)
        throw Failure("--output and --stats are both '-', the standard output; one of them must be a file");
    if (options.order_low && options.order_high && *options.order_high < *options.order_low)
        throw Failure("--order-high: " + std::to_string(*options.order_high) +
                      " is below --order-low, which is " + std::to_string(*options.order_low));
    if (options.tolerance && (options.order_low || options.order_high))
        throw Failure("--tolerance chooses the orders; they cannot be given too");
    return options;
}
