-- SPDX-License-Identifier: MIT
-- Nicol 0.1.0 for LuaJIT. Made of the C headers by samples/bindings/generate.py: change those, not this file.
local ffi = require("ffi")

ffi.cdef[[
typedef int32_t nicol_result;
typedef void (*nicol_log_callback)(void* user, uint32_t severity, nicol_result code, const char* message);
typedef void (*nicol_error_callback)(void* user, nicol_result code, const char* message, const char* function);
typedef int32_t (*nicol_progress_callback)(void* user, const char* verb, double fraction);
typedef struct nicol_context_impl* nicol_context;
typedef struct nicol_environment_impl* nicol_environment;
typedef struct nicol_texture_impl* nicol_texture;
typedef struct nicol_material_impl* nicol_material;
typedef struct nicol_mesh_impl* nicol_mesh;
typedef struct nicol_scene_impl* nicol_scene;
typedef struct nicol_framebuffer_impl* nicol_framebuffer;
typedef struct nicol_spectrum {
    uint32_t count;
    float values[16];
} nicol_spectrum;
typedef uint32_t nicol_backend;
typedef struct nicol_device_info {
    uint32_t struct_size;
    uint32_t software;
    const char* name;
    const char* vendor;
    const char* file;
    const char* pci_address;
} nicol_device_info;
typedef void (*nicol_task)(void* data);
typedef void* (*nicol_start_tasks)(void* user, uint32_t count, nicol_task task, void* data);
typedef void (*nicol_finish_tasks)(void* user, void* started);
typedef int32_t (*nicol_memory_callback)(void* user, int64_t bytes);
typedef struct nicol_context_options {
    uint32_t struct_size;
    nicol_backend backend;
    uint32_t device;
    uint32_t threads;
    nicol_log_callback log;
    void* log_user;
    const char* cache_folder;
    uint64_t memory_limit;
    uint64_t load_bytes_limit;
    uint64_t vertex_limit;
    uint64_t triangle_limit;
    double load_seconds_limit;
    nicol_progress_callback load_progress;
    void* load_progress_user;
    nicol_error_callback error;
    void* error_user;
    nicol_start_tasks start_tasks;
    nicol_finish_tasks finish_tasks;
    void* tasks_user;
    nicol_memory_callback memory;
    void* memory_user;
} nicol_context_options;
typedef struct nicol_context_info {
    uint32_t struct_size;
    nicol_backend backend;
    uint32_t software;
    uint32_t threads;
    const char* renderer;
    const char* vendor;
    const char* version;
    uint32_t max_framebuffer_size;
    uint32_t reserved;
    uint64_t memory_limit;
    uint64_t load_bytes_limit;
    uint64_t vertex_limit;
    uint64_t triangle_limit;
    double load_seconds_limit;
    const char* device_uuid;
    const char* driver_uuid;
    uint64_t device_bytes;
} nicol_context_info;
typedef struct nicol_file_content {
    uint32_t struct_size;
    uint32_t reserved;
    const void* bytes;
    uint64_t byte_size;
} nicol_file_content;
typedef int32_t (*nicol_resolve_callback)(void* user, const char* name, nicol_file_content* content);
typedef struct nicol_memory_file {
    uint32_t struct_size;
    uint32_t reserved;
    const char* name;
    const void* bytes;
    uint64_t byte_size;
    nicol_resolve_callback resolve;
    void* resolve_user;
} nicol_memory_file;
typedef int32_t (*nicol_sink_callback)(void* user, const void* bytes, uint64_t byte_size);
typedef void (*nicol_release_callback)(void* user);
typedef struct nicol_image {
    uint32_t struct_size;
    uint32_t width;
    uint32_t height;
    uint32_t channels;
    uint32_t components;
    const float* pixels;
    uint64_t row_stride;
    uint64_t byte_size;
    nicol_release_callback release;
    void* release_user;
} nicol_image;
typedef struct nicol_sky {
    uint32_t struct_size;
    float dop_max;
    float sun_direction[3];
    nicol_spectrum radiance;
    float turbidity;
    float ground_albedo;
} nicol_sky;
typedef struct nicol_environment_load_options {
    uint32_t struct_size;
    uint32_t reserved;
    double scale;
    nicol_spectrum wavelengths;
} nicol_environment_load_options;
typedef struct nicol_environment_info {
    uint32_t struct_size;
    uint32_t channels;
    uint32_t polarized;
    uint32_t circular;
    uint32_t wavelength_count;
    uint32_t reserved;
    double wavelengths[16];
} nicol_environment_info;
typedef uint32_t nicol_texture_filter;
typedef uint32_t nicol_texture_wrap;
typedef uint32_t nicol_texel;
typedef struct nicol_texture_image {
    uint32_t struct_size;
    nicol_texel type;
    uint32_t width;
    uint32_t height;
    uint32_t channels;
    uint32_t reserved;
    const void* pixels;
    uint64_t row_stride;
    uint64_t byte_size;
} nicol_texture_image;
typedef struct nicol_texture_options {
    uint32_t struct_size;
    nicol_texture_filter filter;
    nicol_texture_wrap wrap;
    uint32_t raw;
    double to_uv[9];
} nicol_texture_options;
typedef uint32_t nicol_distribution;
typedef struct nicol_film {
    float thickness;
    float eta;
    float k;
    uint32_t reserved;
    nicol_spectrum wavelengths;
} nicol_film;
typedef struct nicol_pplastic {
    uint32_t struct_size;
    nicol_distribution distribution;
    nicol_spectrum diffuse_reflectance;
    nicol_spectrum specular_reflectance;
    float int_ior;
    float ext_ior;
    float alpha;
    uint32_t reserved;
    nicol_texture diffuse_reflectance_texture;
    nicol_texture specular_reflectance_texture;
    nicol_texture alpha_texture;
    float alpha_u;
    float alpha_v;
    nicol_texture alpha_u_texture;
    nicol_texture alpha_v_texture;
    nicol_film film;
    nicol_texture film_thickness_texture;
    double film_thickness_least;
} nicol_pplastic;
typedef struct nicol_plastic {
    uint32_t struct_size;
    nicol_distribution distribution;
    nicol_spectrum diffuse_reflectance;
    nicol_spectrum specular_reflectance;
    float int_ior;
    float ext_ior;
    float alpha;
    uint32_t nonlinear;
    nicol_texture diffuse_reflectance_texture;
    nicol_texture specular_reflectance_texture;
    nicol_texture alpha_texture;
} nicol_plastic;
typedef struct nicol_principled {
    uint32_t struct_size;
    float eta;
    nicol_spectrum base_color;
    float roughness;
    float anisotropic;
    float metallic;
    float spec_trans;
    float spec_tint;
    float sheen;
    float sheen_tint;
    float flatness;
    float clearcoat;
    float clearcoat_gloss;
    uint32_t reserved;
    nicol_texture base_color_texture;
    nicol_texture roughness_texture;
    nicol_texture anisotropic_texture;
    nicol_texture metallic_texture;
    nicol_texture spec_trans_texture;
    nicol_texture spec_tint_texture;
    nicol_texture sheen_texture;
    nicol_texture sheen_tint_texture;
    nicol_texture flatness_texture;
    nicol_texture clearcoat_texture;
    nicol_texture clearcoat_gloss_texture;
} nicol_principled;
typedef struct nicol_conductor {
    uint32_t struct_size;
    nicol_distribution distribution;
    float alpha;
    uint32_t reserved;
    const char* metal;
    nicol_spectrum eta;
    nicol_spectrum k;
    nicol_spectrum wavelengths;
    nicol_spectrum specular_reflectance;
    nicol_texture specular_reflectance_texture;
    nicol_texture alpha_texture;
    float alpha_u;
    float alpha_v;
    nicol_texture alpha_u_texture;
    nicol_texture alpha_v_texture;
    nicol_film film;
    nicol_texture film_thickness_texture;
    double film_thickness_least;
} nicol_conductor;
typedef struct nicol_dielectric {
    uint32_t struct_size;
    uint32_t thin;
    float int_ior;
    float ext_ior;
    nicol_spectrum specular_reflectance;
    nicol_spectrum specular_transmittance;
    nicol_spectrum absorption;
    float alpha;
    nicol_distribution distribution;
    nicol_texture alpha_texture;
    nicol_film film;
} nicol_dielectric;
typedef uint32_t nicol_wavelength_sampling;
typedef struct nicol_measured {
    uint32_t struct_size;
    nicol_wavelength_sampling sampling;
    nicol_spectrum wavelengths;
    uint32_t symmetrize;
} nicol_measured;
typedef struct nicol_psh_matrix {
    uint32_t struct_size;
    uint32_t symmetrize;
    nicol_spectrum scale;
} nicol_psh_matrix;
typedef int32_t (*nicol_mueller_callback)(void* user, uint32_t channel, const double towards_light[3], const double towards_viewer[3], double mueller[16]);
typedef struct nicol_callback_material {
    uint32_t struct_size;
    uint32_t channels;
    nicol_mueller_callback mueller;
    void* user;
    nicol_release_callback release;
    float lobe_width;
    uint32_t reserved;
} nicol_callback_material;
typedef struct nicol_mesh_data {
    uint32_t struct_size;
    uint32_t vertex_count;
    uint32_t triangle_count;
    uint32_t texcoord_count;
    const float* positions;
    const float* normals;
    const uint32_t* indices;
    const float* texcoords;
    const uint32_t* texcoord_indices;
    const float* colors;
    const float* face_colors;
    const float* tangents;
} nicol_mesh_data;
typedef struct nicol_deformation {
    uint32_t struct_size;
    uint32_t vertex_count;
    const float* positions;
    const float* normals;
} nicol_deformation;
typedef uint32_t nicol_projection;
typedef struct nicol_camera {
    uint32_t struct_size;
    nicol_projection projection;
    double to_world[16];
    double fov;
    double near_clip;
    double far_clip;
    double jitter[2];
    double shift[2];
    double pixel_aspect;
} nicol_camera;
typedef struct nicol_polarization {
    double dolp;
    double aolp;
    double docp;
    double axis[3];
} nicol_polarization;
typedef uint32_t nicol_light_kind;
typedef struct nicol_light {
    uint32_t struct_size;
    nicol_light_kind kind;
    nicol_spectrum value;
    uint32_t reserved;
    double to_world[16];
    double angular_radius;
    double cutoff_angle;
    double beam_width;
    double fov;
    double aspect;
    nicol_texture texture;
    nicol_polarization polarization;
} nicol_light;
typedef struct nicol_emission {
    uint32_t struct_size;
    uint32_t two_sided;
    nicol_spectrum radiance;
    uint32_t reserved;
    nicol_texture texture;
    nicol_polarization polarization;
} nicol_emission;
typedef uint32_t nicol_polarization_element_kind;
typedef uint32_t nicol_polarization_element_outline;
typedef struct nicol_polarization_element {
    uint32_t struct_size;
    nicol_polarization_element_kind kind;
    nicol_polarization_element_outline outline;
    uint32_t reserved;
    double to_world[16];
    double angle;
    double retardance;
    double transmittance;
    nicol_texture angle_texture;
    nicol_texture retardance_texture;
} nicol_polarization_element;
typedef struct nicol_instance {
    uint32_t struct_size;
    uint32_t flags;
    nicol_mesh mesh;
    nicol_material material;
    double to_world[16];
} nicol_instance;
typedef struct nicol_scene_file {
    uint32_t struct_size;
    uint32_t reserved;
    const char* path;
    const char* digest;
    uint64_t bytes;
} nicol_scene_file;
typedef uint32_t nicol_method;
typedef uint32_t nicol_high_orders;
typedef uint32_t nicol_shade_at;
typedef uint32_t nicol_executor;
typedef uint32_t nicol_components;
typedef uint32_t nicol_filter_kind;
typedef struct nicol_filter {
    nicol_filter_kind kind;
    uint32_t reserved;
    double size;
    double b;
    double c;
} nicol_filter;
typedef struct nicol_render_options {
    uint32_t struct_size;
    nicol_method method;
    uint32_t order_low;
    uint32_t order_high;
    nicol_high_orders high_orders;
    uint32_t shadows;
    uint32_t bake_directions;
    uint32_t physical;
    double dering;
    nicol_progress_callback progress;
    void* progress_user;
    uint32_t samples;
    nicol_executor executor;
    uint64_t seed;
    double tolerance;
    nicol_components components;
    uint32_t disabled_optimisations;
    uint32_t high_order_shadows;
    uint32_t aovs;
    nicol_shade_at shade_at;
    uint32_t pixel_samples;
    double refine_tolerance;
    uint64_t max_vertices;
    int32_t split_lights;
    uint32_t light_samples;
    uint32_t bsdf_samples;
    int32_t max_depth;
    uint32_t fail_if_busy;
    uint32_t reserved;
    double bake_budget_ms;
    nicol_filter filter;
    double time_budget_ms;
} nicol_render_options;
typedef uint32_t nicol_quality;
typedef struct nicol_job_impl* nicol_job;
typedef uint32_t nicol_job_state;
typedef struct nicol_job_status {
    uint32_t struct_size;
    nicol_job_state state;
    nicol_result result;
    uint32_t reserved;
    double fraction;
    const char* verb;
} nicol_job_status;
typedef struct nicol_statistics {
    uint32_t struct_size;
    uint32_t order;
    uint64_t vertices;
    uint64_t triangles;
    double project_ms;
    double bake_ms;
    double relight_ms;
    double shade_ms;
    double draw_ms;
    double observe_ms;
    double bake_trace_ms;
    uint64_t bake_rays;
    uint64_t vertices_skipped;
    uint64_t vertices_unoccluded;
    uint64_t vertices_unphysical;
    uint64_t light_columns_skipped;
    uint64_t response_rows_skipped;
    uint64_t channels_shared;
    uint64_t response_bytes;
    uint64_t visibility_bytes;
    uint64_t transfer_bytes;
    uint64_t buffer_bytes;
    uint64_t texture_bytes;
    uint64_t camera_rays;
    uint64_t shadow_rays;
    double trace_ms;
    uint32_t compute;
    uint32_t order_low;
    double predicted_error;
    uint64_t lights_projected;
    uint64_t materials_projected;
    uint64_t vertices_traced;
    uint64_t matrices_baked;
    uint64_t vertices_relit;
    uint64_t vertices_shaded;
    uint64_t pixels_shaded;
    uint64_t vertices_added;
    uint64_t local_lights;
    uint64_t lights_split;
    uint64_t light_rays;
    double light_ms;
    uint64_t smooth_rays;
    uint64_t vertices_pending;
    double bounce_ms;
    uint64_t bounce_links;
    uint64_t bounce_rounds;
    double bounced_light;
    double bounced_left;
    uint64_t bake_rays_skipped;
    uint64_t vertices_unbaked;
    uint32_t given_up;
    uint32_t pixel_samples;
    uint32_t light_samples;
    uint32_t bsdf_samples;
    double order_tolerance;
    uint64_t light_rays_skipped;
} nicol_statistics;
typedef uint32_t nicol_plane;
typedef uint32_t nicol_format;
typedef struct nicol_plane_buffer {
    uint32_t struct_size;
    nicol_plane plane;
    nicol_format format;
    uint32_t channel;
    void* pixels;
    uint64_t row_stride;
    uint64_t byte_size;
    double polarizer_angle;
} nicol_plane_buffer;
typedef uint32_t nicol_observation_kind;
typedef struct nicol_observation {
    uint32_t struct_size;
    nicol_observation_kind kind;
    float exposure;
    float scale;
    float polarizer_angle;
} nicol_observation;
typedef uint32_t nicol_mosaic;
typedef struct nicol_sensor {
    uint32_t struct_size;
    nicol_mosaic mosaic;
    uint32_t bits;
    uint32_t shot_noise;
    uint64_t seed;
    double optics[16];
    double exposure;
    double exposure_time;
    double full_well;
    double gain;
    double black_level;
    double read_noise;
    double dark_current;
    double dsnu;
    double prnu;
    double extinction_ratio;
    double extinction_spread;
    double misalignment;
    double crosstalk;
    double crosstalk_spread;
    double blur;
    double vignetting;
    nicol_spectrum quantum_efficiency;
    uint32_t reserved;
} nicol_sensor;
typedef uint32_t nicol_sensor_preset;
typedef struct nicol_stokes_image {
    uint32_t struct_size;
    uint32_t width;
    uint32_t height;
    uint32_t channels;
    void* pixels;
    uint64_t row_stride;
    uint64_t byte_size;
} nicol_stokes_image;
typedef struct nicol_raw_image {
    uint32_t struct_size;
    uint32_t width;
    uint32_t height;
    uint32_t reserved;
    void* pixels;
    uint64_t row_stride;
    uint64_t byte_size;
} nicol_raw_image;
typedef uint32_t nicol_demosaic;
typedef struct nicol_gradient {
    uint32_t struct_size;
    uint32_t reserved;
    double* environment;
    uint64_t environment_count;
    double* lights;
    uint64_t lights_count;
    double* instances;
    uint64_t instances_count;
    nicol_texture texture;
    double* texels;
    uint64_t texels_count;
} nicol_gradient;
typedef void* (*nicol_get_proc_address_callback)(void* user, const char* name);
typedef int32_t (*nicol_is_current_callback)(void* user);
typedef struct nicol_host {
    uint32_t struct_size;
    uint32_t flags;
    nicol_get_proc_address_callback get_proc_address;
    nicol_is_current_callback is_current;
    void* user;
} nicol_host;
typedef struct nicol_gl_texture {
    uint32_t struct_size;
    uint32_t name;
    uint32_t target;
    uint32_t internal_format;
    uint32_t width;
    uint32_t height;
} nicol_gl_texture;
typedef uint32_t nicol_encoding;
typedef uint32_t nicol_depth_mapping;
typedef struct nicol_texture_target {
    uint32_t struct_size;
    uint32_t texture;
    uint32_t bottom_up;
    nicol_encoding encoding;
    uint32_t depth_texture;
    nicol_depth_mapping depth_mapping;
    float depth_near;
    float depth_far;
} nicol_texture_target;
typedef uint32_t nicol_psh_grid;
typedef struct nicol_psh_sampling {
    uint32_t struct_size;
    nicol_psh_grid grid;
    uint32_t order;
    uint32_t rows;
    uint32_t columns;
    uint32_t reserved;
    double phi0;
} nicol_psh_sampling;
typedef struct nicol_psh_transform_impl* nicol_psh_transform;
typedef int32_t (*nicol_psh_mueller_callback)(void* user, const double in[3], const double out[3], double mueller[16]);
typedef struct nicol_psh_mueller_field {
    uint32_t struct_size;
    uint32_t isotropic;
    uint32_t order_out;
    uint32_t order_in;
    uint32_t rows_out;
    uint32_t columns_out;
    uint32_t rows_in;
    uint32_t columns_in;
    nicol_psh_mueller_callback callback;
    void* user;
} nicol_psh_mueller_field;
typedef int32_t (*nicol_psh_kernel_callback)(void* user, double theta, double mueller[16]);
typedef uint32_t nicol_file_kind;
typedef struct nicol_file_options {
    uint32_t struct_size;
    uint32_t order;
    uint32_t width;
    uint32_t height;
    uint32_t edge;
    uint32_t flags;
    double scale;
    double rotation[9];
    nicol_spectrum wavelengths;
    uint32_t reserved;
} nicol_file_options;
typedef struct nicol_light_report {
    uint32_t struct_size;
    nicol_file_kind kind;
    uint32_t channels;
    uint32_t order;
    uint32_t width;
    uint32_t height;
    uint32_t polarized;
    uint32_t circular;
    double wavelengths[16];
    double mean[16];
    double smallest[16];
    double largest[16];
    double direction[48];
    double mean_dolp[16];
    double largest_dolp[16];
    double largest_circular[16];
    double unphysical[16];
    double largest_excess[16];
} nicol_light_report;
typedef struct nicol_material_report {
    uint32_t struct_size;
    nicol_file_kind kind;
    uint32_t channels;
    uint32_t order;
    uint32_t file_order;
    uint32_t stokes_columns;
    uint32_t measured_wavelengths;
    uint32_t reserved;
    double measured_range[2];
    double wavelengths[16];
    double albedo[16];
    double largest_albedo[16];
    double norms[144];
    double asymmetry[16];
    double unphysical[16];
    double excess[16];
} nicol_material_report;
uint32_t nicol_version(void);
const char* nicol_version_string(void);
const char* nicol_build_info(uint32_t index);
const char* nicol_last_error(void);
const char* nicol_result_name(nicol_result result);
nicol_result nicol_spectrum_init(nicol_spectrum* descriptor, uint32_t struct_size);
nicol_result nicol_device_count(uint32_t* count);
nicol_result nicol_device_info_init(nicol_device_info* descriptor, uint32_t struct_size);
nicol_result nicol_device_get_info(uint32_t device, nicol_device_info* info);
nicol_result nicol_context_options_init(nicol_context_options* descriptor, uint32_t struct_size);
nicol_result nicol_context_info_init(nicol_context_info* descriptor, uint32_t struct_size);
nicol_result nicol_context_create(const nicol_context_options* options, nicol_context* context);
nicol_result nicol_context_retain(nicol_context context);
nicol_result nicol_context_release(nicol_context context);
nicol_result nicol_context_set_log(nicol_context context, nicol_log_callback log, void* log_user);
nicol_result nicol_context_get_info(nicol_context context, nicol_context_info* info);
nicol_result nicol_file_content_init(nicol_file_content* descriptor, uint32_t struct_size);
nicol_result nicol_memory_file_init(nicol_memory_file* descriptor, uint32_t struct_size);
nicol_result nicol_image_init(nicol_image* descriptor, uint32_t struct_size);
nicol_result nicol_sky_init(nicol_sky* descriptor, uint32_t struct_size);
nicol_result nicol_environment_load_options_init(nicol_environment_load_options* descriptor, uint32_t struct_size);
nicol_result nicol_environment_load(nicol_context context, const char* path, const nicol_environment_load_options* options, nicol_environment* environment);
nicol_result nicol_environment_load_memory(nicol_context context, const nicol_memory_file* file, const nicol_environment_load_options* options, nicol_environment* environment);
nicol_result nicol_environment_create_image(nicol_context context, const nicol_image* image, nicol_environment* environment);
nicol_result nicol_environment_create_constant(nicol_context context, const nicol_spectrum* radiance, nicol_environment* environment);
nicol_result nicol_environment_create_sky(nicol_context context, const nicol_sky* sky, nicol_environment* environment);
nicol_result nicol_environment_create_psh(nicol_context context, uint32_t order, uint32_t channels, const double* coefficients, uint64_t count, nicol_environment* environment);
nicol_result nicol_environment_info_init(nicol_environment_info* descriptor, uint32_t struct_size);
nicol_result nicol_environment_get_info(nicol_environment environment, nicol_environment_info* info);
nicol_result nicol_environment_retain(nicol_environment environment);
nicol_result nicol_environment_release(nicol_environment environment);
nicol_result nicol_texture_image_init(nicol_texture_image* descriptor, uint32_t struct_size);
nicol_result nicol_texture_options_init(nicol_texture_options* descriptor, uint32_t struct_size);
nicol_result nicol_texture_create_image(nicol_context context, const nicol_texture_image* image, const nicol_texture_options* options, nicol_texture* texture);
nicol_result nicol_texture_load(nicol_context context, const char* path, const nicol_texture_options* options, nicol_texture* texture);
nicol_result nicol_texture_load_memory(nicol_context context, const nicol_memory_file* file, const nicol_texture_options* options, nicol_texture* texture);
nicol_result nicol_texture_create_checkerboard(nicol_context context, const nicol_spectrum* color0, const nicol_spectrum* color1, const double to_uv[9], nicol_texture* texture);
nicol_result nicol_texture_create_vertex_colors(nicol_context context, nicol_texture* texture);
nicol_result nicol_texture_create_face_colors(nicol_context context, nicol_texture* texture);
nicol_result nicol_texture_retain(nicol_texture texture);
nicol_result nicol_texture_release(nicol_texture texture);
nicol_result nicol_film_init(nicol_film* descriptor, uint32_t struct_size);
nicol_result nicol_pplastic_init(nicol_pplastic* descriptor, uint32_t struct_size);
nicol_result nicol_material_create_pplastic(nicol_context context, const nicol_pplastic* parameters, nicol_material* material);
nicol_result nicol_plastic_init(nicol_plastic* descriptor, uint32_t struct_size);
nicol_result nicol_material_create_plastic(nicol_context context, const nicol_plastic* parameters, nicol_material* material);
nicol_result nicol_principled_init(nicol_principled* descriptor, uint32_t struct_size);
nicol_result nicol_material_create_principled(nicol_context context, const nicol_principled* parameters, nicol_material* material);
nicol_result nicol_material_create_diffuse(nicol_context context, const nicol_spectrum* reflectance, nicol_material* material);
nicol_result nicol_conductor_init(nicol_conductor* descriptor, uint32_t struct_size);
nicol_result nicol_material_create_conductor(nicol_context context, const nicol_conductor* parameters, nicol_material* material);
nicol_result nicol_dielectric_init(nicol_dielectric* descriptor, uint32_t struct_size);
nicol_result nicol_material_create_dielectric(nicol_context context, const nicol_dielectric* parameters, nicol_material* material);
nicol_result nicol_measured_init(nicol_measured* descriptor, uint32_t struct_size);
nicol_result nicol_material_load_measured(nicol_context context, const char* path, const nicol_measured* options, nicol_material* material);
nicol_result nicol_material_load_measured_memory(nicol_context context, const nicol_memory_file* file, const nicol_measured* options, nicol_material* material);
nicol_result nicol_psh_matrix_init(nicol_psh_matrix* descriptor, uint32_t struct_size);
nicol_result nicol_material_load_psh(nicol_context context, const char* path, const nicol_psh_matrix* options, nicol_material* material);
nicol_result nicol_material_load_psh_memory(nicol_context context, const nicol_memory_file* file, const nicol_psh_matrix* options, nicol_material* material);
nicol_result nicol_material_create_twosided(nicol_context context, nicol_material front, nicol_material* material);
nicol_result nicol_material_create_scaled(nicol_context context, nicol_material base, nicol_texture scale, nicol_material* material);
nicol_result nicol_material_create_blend(nicol_context context, nicol_material first, nicol_material second, nicol_texture weight, nicol_material* material);
nicol_result nicol_material_create_normal_map(nicol_context context, nicol_material base, nicol_texture normals, uint32_t mirrored_y, nicol_material* material);
nicol_result nicol_material_create_bump_map(nicol_context context, nicol_material base, nicol_texture heights, double scale, nicol_material* material);
nicol_result nicol_material_create_rotated(nicol_context context, nicol_material base, nicol_texture directions, double angle, nicol_material* material);
nicol_result nicol_material_create_mask(nicol_context context, nicol_material base, nicol_texture opacity, nicol_material* material);
nicol_result nicol_callback_material_init(nicol_callback_material* descriptor, uint32_t struct_size);
nicol_result nicol_material_create_callback(nicol_context context, const nicol_callback_material* parameters, nicol_material* material);
nicol_result nicol_material_retain(nicol_material material);
nicol_result nicol_material_release(nicol_material material);
nicol_result nicol_mesh_data_init(nicol_mesh_data* descriptor, uint32_t struct_size);
nicol_result nicol_mesh_load(nicol_context context, const char* path, nicol_mesh* mesh);
nicol_result nicol_mesh_load_memory(nicol_context context, const nicol_memory_file* file, nicol_mesh* mesh);
nicol_result nicol_mesh_create(nicol_context context, const nicol_mesh_data* data, nicol_mesh* mesh);
nicol_result nicol_mesh_create_sphere(nicol_context context, nicol_mesh* mesh);
nicol_result nicol_mesh_create_divided_sphere(nicol_context context, uint32_t segments, nicol_mesh* mesh);
nicol_result nicol_mesh_create_rectangle(nicol_context context, nicol_mesh* mesh);
nicol_result nicol_mesh_create_cube(nicol_context context, nicol_mesh* mesh);
nicol_result nicol_mesh_create_disk(nicol_context context, nicol_mesh* mesh);
nicol_result nicol_mesh_create_cylinder(nicol_context context, const double p0[3], const double p1[3], double radius, nicol_mesh* mesh);
nicol_result nicol_deformation_init(nicol_deformation* descriptor, uint32_t struct_size);
nicol_result nicol_mesh_create_deformed(nicol_context context, nicol_mesh base, const nicol_deformation* deformation, nicol_mesh* mesh);
nicol_result nicol_mesh_get_size(nicol_mesh mesh, uint32_t* vertices, uint32_t* triangles);
nicol_result nicol_mesh_get_bounds(nicol_mesh mesh, double lower[3], double upper[3]);
nicol_result nicol_mesh_retain(nicol_mesh mesh);
nicol_result nicol_mesh_release(nicol_mesh mesh);
nicol_result nicol_camera_init(nicol_camera* descriptor, uint32_t struct_size);
nicol_result nicol_camera_look_at(nicol_camera* camera, const double origin[3], const double target[3], const double up[3]);
nicol_result nicol_camera_set_opencv(nicol_camera* camera, const double K[9], const double R[9], const double t[3], uint32_t width, uint32_t height);
nicol_result nicol_camera_get_opencv(const nicol_camera* camera, uint32_t width, uint32_t height, double K[9], double R[9], double t[3]);
nicol_result nicol_camera_frame(nicol_camera* camera, const double lower[3], const double upper[3], uint32_t width, uint32_t height);
nicol_result nicol_polarization_init(nicol_polarization* descriptor, uint32_t struct_size);
nicol_result nicol_light_init(nicol_light* descriptor, uint32_t struct_size);
nicol_result nicol_sky_get_sun(const nicol_sky* sky, nicol_light* light);
nicol_result nicol_emission_init(nicol_emission* descriptor, uint32_t struct_size);
nicol_result nicol_polarization_element_init(nicol_polarization_element* descriptor, uint32_t struct_size);
nicol_result nicol_instance_init(nicol_instance* descriptor, uint32_t struct_size);
nicol_result nicol_scene_create(nicol_context context, nicol_scene* scene);
nicol_result nicol_scene_load(nicol_context context, const char* path, const char* const* definitions, uint32_t definition_count, nicol_scene* scene);
nicol_result nicol_scene_set_time(nicol_scene scene, double time);
nicol_result nicol_scene_load_memory(nicol_context context, const nicol_memory_file* file, const char* const* definitions, uint32_t definition_count, nicol_scene* scene);
nicol_result nicol_scene_add_instance(nicol_scene scene, const nicol_instance* instance, uint32_t* id);
nicol_result nicol_scene_set_transform(nicol_scene scene, uint32_t id, const double to_world[16]);
nicol_result nicol_scene_set_mesh(nicol_scene scene, uint32_t id, nicol_mesh mesh);
nicol_result nicol_scene_set_material(nicol_scene scene, uint32_t id, nicol_material material);
nicol_result nicol_scene_set_instance_flags(nicol_scene scene, uint32_t id, uint32_t flags);
nicol_result nicol_scene_get_instance_flags(nicol_scene scene, uint32_t id, uint32_t* flags);
nicol_result nicol_scene_remove_instance(nicol_scene scene, uint32_t id);
nicol_result nicol_scene_get_instance(nicol_scene scene, uint32_t id, nicol_mesh* mesh, nicol_material* material, double to_world[16]);
nicol_result nicol_scene_get_bounds(nicol_scene scene, double lower[3], double upper[3]);
nicol_result nicol_scene_get_instance_count(nicol_scene scene, uint32_t* instances);
nicol_result nicol_scene_get_instance_ids(nicol_scene scene, uint32_t* ids, uint64_t count);
nicol_result nicol_scene_set_environment(nicol_scene scene, nicol_environment environment, const double to_world[16], double scale);
nicol_result nicol_scene_get_environment(nicol_scene scene, nicol_environment* environment, double to_world[16], double* scale);
nicol_result nicol_scene_hide_emitters(nicol_scene scene, uint32_t hide);
nicol_result nicol_scene_add_light(nicol_scene scene, const nicol_light* light, uint32_t* id);
nicol_result nicol_scene_set_light(nicol_scene scene, uint32_t id, const nicol_light* light);
nicol_result nicol_scene_remove_light(nicol_scene scene, uint32_t id);
nicol_result nicol_scene_get_light(nicol_scene scene, uint32_t id, nicol_light* light, nicol_texture* texture);
nicol_result nicol_scene_get_light_count(nicol_scene scene, uint32_t* lights);
nicol_result nicol_scene_get_light_ids(nicol_scene scene, uint32_t* ids, uint64_t count);
nicol_result nicol_scene_set_emission(nicol_scene scene, uint32_t id, const nicol_emission* emission);
nicol_result nicol_scene_get_emission(nicol_scene scene, uint32_t id, nicol_emission* emission, nicol_texture* texture);
nicol_result nicol_scene_add_polarization_element(nicol_scene scene, const nicol_polarization_element* element, uint32_t* id);
nicol_result nicol_scene_set_polarization_element(nicol_scene scene, uint32_t id, const nicol_polarization_element* element);
nicol_result nicol_scene_remove_polarization_element(nicol_scene scene, uint32_t id);
nicol_result nicol_scene_get_polarization_element(nicol_scene scene, uint32_t id, nicol_polarization_element* element);
nicol_result nicol_scene_get_polarization_element_textures(nicol_scene scene, uint32_t id, nicol_texture* angle, nicol_texture* retardance);
nicol_result nicol_scene_get_polarization_element_count(nicol_scene scene, uint32_t* elements);
nicol_result nicol_scene_get_polarization_element_ids(nicol_scene scene, uint32_t* ids, uint64_t count);
nicol_result nicol_scene_get_camera(nicol_scene scene, nicol_camera* camera);
nicol_result nicol_scene_get_film_size(nicol_scene scene, uint32_t* width, uint32_t* height);
nicol_result nicol_scene_get_sample_count(nicol_scene scene, uint32_t* samples);
nicol_result nicol_scene_get_max_depth(nicol_scene scene, int32_t* max_depth);
nicol_result nicol_scene_get_aovs(nicol_scene scene, uint32_t* aovs);
nicol_result nicol_scene_file_init(nicol_scene_file* descriptor, uint32_t struct_size);
nicol_result nicol_scene_get_file_count(nicol_scene scene, uint32_t* count);
nicol_result nicol_scene_get_file(nicol_scene scene, uint32_t index, nicol_scene_file* file);
nicol_result nicol_scene_get_channels(nicol_scene scene, uint32_t* channels);
nicol_result nicol_scene_retain(nicol_scene scene);
nicol_result nicol_scene_release(nicol_scene scene);
nicol_result nicol_filter_init(nicol_filter* descriptor, uint32_t struct_size);
nicol_result nicol_scene_get_filter(nicol_scene scene, nicol_filter* filter);
nicol_result nicol_render_options_init(nicol_render_options* descriptor, uint32_t struct_size);
nicol_result nicol_render_options_set_quality(nicol_render_options* options, nicol_quality quality);
nicol_result nicol_framebuffer_create(nicol_context context, uint32_t width, uint32_t height, uint32_t channels, nicol_framebuffer* framebuffer);
nicol_result nicol_framebuffer_resize(nicol_framebuffer framebuffer, uint32_t width, uint32_t height);
nicol_result nicol_framebuffer_get_size(nicol_framebuffer framebuffer, uint32_t* width, uint32_t* height, uint32_t* channels);
nicol_result nicol_framebuffer_blend(nicol_framebuffer framebuffer, nicol_framebuffer other, double weight);
nicol_result nicol_framebuffer_retain(nicol_framebuffer framebuffer);
nicol_result nicol_framebuffer_release(nicol_framebuffer framebuffer);
nicol_result nicol_render(nicol_scene scene, const nicol_camera* camera, const nicol_render_options* options, nicol_framebuffer framebuffer);
nicol_result nicol_render_views(nicol_scene scene, const nicol_camera* cameras, const nicol_framebuffer* framebuffers, uint32_t count, const nicol_render_options* options);
nicol_result nicol_render_async(nicol_scene scene, const nicol_camera* camera, const nicol_render_options* options, nicol_framebuffer framebuffer, nicol_job* job);
nicol_result nicol_job_status_init(nicol_job_status* descriptor, uint32_t struct_size);
nicol_result nicol_job_poll(nicol_job job, nicol_job_status* status);
nicol_result nicol_job_wait(nicol_job job, uint32_t timeout_ms);
nicol_result nicol_job_cancel(nicol_job job);
nicol_result nicol_job_retain(nicol_job job);
nicol_result nicol_job_release(nicol_job job);
nicol_result nicol_statistics_init(nicol_statistics* descriptor, uint32_t struct_size);
nicol_result nicol_framebuffer_get_statistics(nicol_framebuffer framebuffer, nicol_statistics* statistics);
nicol_result nicol_framebuffer_read(nicol_framebuffer framebuffer, nicol_plane plane, uint32_t channel, float* pixels, uint64_t row_stride, uint64_t byte_size);
nicol_result nicol_plane_buffer_init(nicol_plane_buffer* descriptor, uint32_t struct_size);
nicol_result nicol_framebuffer_read_plane(nicol_framebuffer framebuffer, const nicol_plane_buffer* to);
nicol_result nicol_framebuffer_write_exr(nicol_framebuffer framebuffer, const char* path);
nicol_result nicol_framebuffer_encode_exr(nicol_framebuffer framebuffer, nicol_sink_callback sink, void* user);
nicol_result nicol_observation_init(nicol_observation* descriptor, uint32_t struct_size);
nicol_result nicol_framebuffer_write_png(nicol_framebuffer framebuffer, const nicol_observation* observation, const char* path);
nicol_result nicol_framebuffer_encode_png(nicol_framebuffer framebuffer, const nicol_observation* observation, nicol_sink_callback sink, void* user);
nicol_result nicol_sensor_init(nicol_sensor* descriptor, uint32_t struct_size);
nicol_result nicol_sensor_set_preset(nicol_sensor* sensor, nicol_sensor_preset preset);
nicol_result nicol_sensor_load(nicol_sensor* sensor, const char* path);
nicol_result nicol_sensor_load_memory(nicol_sensor* sensor, const nicol_memory_file* file);
nicol_result nicol_sensor_add_element(nicol_sensor* sensor, const nicol_polarization_element* element, double extinction_ratio);
nicol_result nicol_stokes_image_init(nicol_stokes_image* descriptor, uint32_t struct_size);
nicol_result nicol_raw_image_init(nicol_raw_image* descriptor, uint32_t struct_size);
nicol_result nicol_sensor_expose(const nicol_sensor* sensor, const nicol_stokes_image* light, uint64_t frame, const nicol_raw_image* to);
nicol_result nicol_framebuffer_expose(nicol_framebuffer framebuffer, const nicol_sensor* sensor, uint64_t frame, const nicol_raw_image* to);
nicol_result nicol_sensor_write_png(const nicol_sensor* sensor, const nicol_raw_image* raw, const char* path);
nicol_result nicol_sensor_demosaic(const nicol_sensor* sensor, const nicol_raw_image* raw, nicol_demosaic method, const nicol_stokes_image* to);
nicol_result nicol_gradient_init(nicol_gradient* descriptor, uint32_t struct_size);
nicol_result nicol_render_adjoint(nicol_scene scene, const nicol_camera* camera, const nicol_render_options* options, const nicol_stokes_image* picture, const nicol_gradient* gradient);
nicol_result nicol_host_init(nicol_host* descriptor, uint32_t struct_size);
nicol_result nicol_context_create_host(const nicol_host* host, const nicol_context_options* options, nicol_context* context);
nicol_result nicol_framebuffer_create_textures(nicol_context context, const uint32_t* textures, uint32_t channels, nicol_framebuffer* framebuffer);
nicol_result nicol_gl_texture_init(nicol_gl_texture* descriptor, uint32_t struct_size);
nicol_result nicol_framebuffer_get_texture(nicol_framebuffer framebuffer, uint32_t channel, nicol_gl_texture* texture);
nicol_result nicol_texture_target_init(nicol_texture_target* descriptor, uint32_t struct_size);
nicol_result nicol_framebuffer_draw_plane(nicol_framebuffer framebuffer, nicol_plane plane, uint32_t channel, const nicol_texture_target* target);
nicol_result nicol_framebuffer_draw_stokes(nicol_framebuffer framebuffer, uint32_t channel, const nicol_texture_target* target);
nicol_result nicol_framebuffer_draw_observation(nicol_framebuffer framebuffer, const nicol_observation* observation, const nicol_texture_target* target);
nicol_result nicol_psh_project_image(const nicol_image* image, uint32_t order, double* coefficients, uint64_t count);
nicol_result nicol_psh_project_environment(nicol_environment environment, uint32_t order, double* coefficients, uint64_t count);
nicol_result nicol_psh_project_file(const char* path, uint32_t order, uint32_t* channels, double* coefficients, uint64_t count);
nicol_result nicol_psh_sampling_init(nicol_psh_sampling* descriptor, uint32_t struct_size);
nicol_result nicol_psh_transform_create(const nicol_psh_sampling* sampling, nicol_psh_transform* transform);
nicol_result nicol_psh_transform_retain(nicol_psh_transform transform);
nicol_result nicol_psh_transform_release(nicol_psh_transform transform);
nicol_result nicol_psh_transform_get_size(nicol_psh_transform transform, uint32_t* rows, uint32_t* columns);
nicol_result nicol_psh_transform_get_rows(nicol_psh_transform transform, double* theta, double* weight, uint64_t count);
nicol_result nicol_psh_analyze(nicol_psh_transform transform, uint64_t vectors, const double* samples, uint64_t sample_count, double* coefficients, uint64_t coefficient_count);
nicol_result nicol_psh_synthesize(nicol_psh_transform transform, uint64_t vectors, const double* coefficients, uint64_t coefficient_count, double* samples, uint64_t sample_count);
nicol_result nicol_psh_evaluate(uint32_t order, uint64_t vectors, const double* coefficients, uint64_t coefficient_count, const double* directions, uint64_t direction_count, double* stokes, uint64_t stokes_count);
nicol_result nicol_psh_rotate(uint32_t order, uint64_t vectors, const double* in, uint64_t in_count, const double rotation[9], double* out, uint64_t out_count);
nicol_result nicol_psh_reflect(uint32_t order, uint64_t vectors, const double* in, uint64_t in_count, double* out, uint64_t out_count);
nicol_result nicol_psh_multiply(uint32_t scalar_order, const double* scalar, uint64_t scalar_count, uint32_t order, uint64_t vectors, const double* in, uint64_t in_count, uint32_t order_out, double* out, uint64_t out_count);
nicol_result nicol_psh_shadow_matrix(uint32_t scalar_order, const double* scalar, uint64_t scalar_count, uint32_t order_out, uint32_t order_in, double* matrix, uint64_t matrix_count);
nicol_result nicol_psh_mueller_field_init(nicol_psh_mueller_field* descriptor, uint32_t struct_size);
nicol_result nicol_psh_project_matrix(const nicol_psh_mueller_field* field, double* matrix, uint64_t matrix_count);
nicol_result nicol_psh_apply_matrix(uint32_t order_out, uint32_t order_in, const double* matrix, uint64_t matrix_count, uint64_t vectors, const double* in, uint64_t in_count, double* out, uint64_t out_count);
nicol_result nicol_psh_compose_matrix(uint32_t order_out, uint32_t order_between, uint32_t order_in, const double* second, uint64_t second_count, const double* first, uint64_t first_count, double* matrix, uint64_t matrix_count);
nicol_result nicol_psh_project_kernel(nicol_psh_kernel_callback callback, void* user, uint32_t order, uint32_t rows, double* bands, uint64_t band_count);
nicol_result nicol_psh_kernel_at(uint32_t order, const double* bands, uint64_t band_count, const double* theta, uint64_t theta_count, double* mueller, uint64_t mueller_count);
nicol_result nicol_psh_convolve(uint32_t order, const double* bands, uint64_t band_count, uint64_t vectors, const double* in, uint64_t in_count, double* out, uint64_t out_count);
nicol_result nicol_psh_kernel_matrix(uint32_t order, const double* bands, uint64_t band_count, double* matrix, uint64_t matrix_count);
nicol_result nicol_psh_nearest_kernel(uint32_t order, const double* matrix, uint64_t matrix_count, double* bands, uint64_t band_count);
nicol_result nicol_file_options_init(nicol_file_options* descriptor, uint32_t struct_size);
nicol_result nicol_light_report_init(nicol_light_report* descriptor, uint32_t struct_size);
nicol_result nicol_material_report_init(nicol_material_report* descriptor, uint32_t struct_size);
nicol_result nicol_file_identify(const char* path, nicol_file_kind* kind);
nicol_result nicol_file_describe_light(const char* path, const nicol_file_options* options, nicol_light_report* report, double* energy, uint64_t count);
nicol_result nicol_file_describe_material(const char* path, const nicol_file_options* options, nicol_material_report* report, double* energy, uint64_t count);
nicol_result nicol_file_convert(const char* in, const nicol_file_options* options, const char* out);
nicol_result nicol_environment_write(nicol_environment environment, const nicol_file_options* options, const char* path);
nicol_result nicol_material_write(nicol_material material, const nicol_file_options* options, const char* path);
nicol_result nicol_file_demosaic(const char* in, const nicol_sensor* sensor, nicol_demosaic method, const char* out);
nicol_result nicol_file_combine_angles(const char* at_0, const char* at_45, const char* at_90, const char* at_135, const char* out);
nicol_result nicol_psh_write_file(const char* path, uint32_t order, uint64_t vectors, const double* coefficients, uint64_t count);
]]

return {
    constants = {
        VERSION_MAJOR = 0,
        VERSION_MINOR = 1,
        VERSION_PATCH = 0,
        VERSION = 100,
        OK = 0,
        ERROR_INVALID_ARGUMENT = 1,
        ERROR_INVALID_HANDLE = 2,
        ERROR_OUT_OF_MEMORY = 3,
        ERROR_FILE_NOT_FOUND = 4,
        ERROR_INVALID_FILE = 5,
        ERROR_WRITE_FAILED = 6,
        ERROR_UNSUPPORTED = 7,
        ERROR_NO_BACKEND = 8,
        ERROR_CANCELLED = 9,
        ERROR_OPENGL = 10,
        ERROR_INTERNAL = 11,
        ERROR_NOT_CURRENT = 12,
        ERROR_TIMEOUT = 13,
        ERROR_BUSY = 14,
        LOG_INFO = 0,
        LOG_NOTICE = 1,
        LOG_WARNING = 2,
        MAX_CHANNELS = 16,
        MAX_ORDER = 32,
        ORDER_AUTOMATIC = 4294967295,
        MAX_SIZE = 16384,
        NO_LIMIT = 18446744073709551615ULL,
        BACKEND_AUTOMATIC = 0,
        BACKEND_EGL = 1,
        BACKEND_OSMESA = 2,
        BACKEND_HOST = 3,
        TEXTURE_FILTER_NEAREST = 0,
        TEXTURE_FILTER_BILINEAR = 1,
        TEXTURE_FILTER_MIPMAP = 2,
        TEXTURE_WRAP_REPEAT = 0,
        TEXTURE_WRAP_MIRROR = 1,
        TEXTURE_WRAP_CLAMP = 2,
        TEXEL_UINT8 = 0,
        TEXEL_UINT16 = 1,
        TEXEL_FLOAT32 = 2,
        DISTRIBUTION_BECKMANN = 0,
        DISTRIBUTION_GGX = 1,
        WAVELENGTH_LINEAR = 0,
        WAVELENGTH_NEAREST = 1,
        PROJECTION_PERSPECTIVE = 0,
        PROJECTION_ORTHOGRAPHIC = 1,
        LIGHT_DIRECTIONAL = 0,
        LIGHT_POINT = 1,
        LIGHT_SPOT = 2,
        LIGHT_PROJECTOR = 3,
        POLARIZATION_ELEMENT_POLARIZER = 0,
        POLARIZATION_ELEMENT_RETARDER = 1,
        POLARIZATION_ELEMENT_RIGHT_CIRCULAR = 2,
        POLARIZATION_ELEMENT_LEFT_CIRCULAR = 3,
        POLARIZATION_ELEMENT_RECTANGLE = 0,
        POLARIZATION_ELEMENT_DISK = 1,
        INSTANCE_CASTS_NO_SHADOWS = 1,
        INSTANCE_RECEIVES_NO_SHADOWS = 2,
        INSTANCE_INVISIBLE = 4,
        METHOD_FACTORED = 0,
        METHOD_DENSE = 1,
        METHOD_REFERENCE = 2,
        HIGH_ORDERS_SPLIT = 0,
        HIGH_ORDERS_CONVOLUTION = 1,
        HIGH_ORDERS_NONE = 2,
        SHADE_AT_AUTOMATIC = 0,
        SHADE_AT_VERTICES = 1,
        SHADE_AT_PIXELS = 2,
        EXECUTOR_AUTOMATIC = 0,
        EXECUTOR_CPU = 1,
        EXECUTOR_COMPUTE = 2,
        OPTIMISATION_UNCHANGED = 1,
        OPTIMISATION_LIGHT_COMPONENTS = 2,
        OPTIMISATION_CHANNELS = 4,
        OPTIMISATION_ORDERS = 8,
        OPTIMISATION_RESPONSE_ROWS = 16,
        OPTIMISATION_HIDDEN = 32,
        OPTIMISATION_UNOCCLUDED = 64,
        OPTIMISATION_RAYS = 128,
        OPTIMISATION_DIM_LIGHTS = 256,
        OPTIMISATION_ALL = 511,
        AOV_DEPTH = 1,
        AOV_NORMAL = 2,
        AOV_POSITION = 4,
        AOV_INSTANCE = 8,
        AOV_ALPHA = 32,
        AOV_ALL = 47,
        AOV_VARIANCE = 16,
        COMPONENTS_ALL = 0,
        COMPONENTS_S0 = 1,
        COMPONENTS_LINEAR = 3,
        FILTER_BOX = 0,
        FILTER_GAUSSIAN = 1,
        FILTER_TENT = 2,
        FILTER_MITCHELL = 3,
        FILTER_CATMULLROM = 4,
        FILTER_LANCZOS = 5,
        DIRECTIONS_AUTOMATIC = 0,
        DEPTH_UNLIMITED = -1,
        SPLIT_AUTOMATIC = -1,
        MAX_SPLIT_LIGHTS = 64,
        QUALITY_REALTIME = 0,
        QUALITY_PREVIEW = 1,
        QUALITY_FINAL = 2,
        MAX_VIEWS = 1024,
        MAX_JOBS = 256,
        JOB_WAITING = 0,
        JOB_RUNNING = 1,
        JOB_DONE = 2,
        WAIT_FOREVER = 4294967295,
        PLANE_S0 = 0,
        PLANE_S1 = 1,
        PLANE_S2 = 2,
        PLANE_S3 = 3,
        PLANE_STOKES = 4,
        PLANE_DOLP = 5,
        PLANE_AOLP = 6,
        PLANE_DEPTH = 7,
        PLANE_NORMAL = 8,
        PLANE_POSITION = 9,
        PLANE_INSTANCE = 10,
        NO_INSTANCE = 4294967295,
        PLANE_VARIANCE = 11,
        PLANE_ALPHA = 12,
        PLANE_POLARIZER = 13,
        FORMAT_AUTOMATIC = 0,
        FORMAT_FLOAT32 = 1,
        FORMAT_FLOAT16 = 2,
        FORMAT_UINT32 = 3,
        ALL_CHANNELS = 4294967295,
        OBSERVATION_S0 = 0,
        OBSERVATION_S1 = 1,
        OBSERVATION_S2 = 2,
        OBSERVATION_S3 = 3,
        OBSERVATION_DOLP = 4,
        OBSERVATION_AOLP = 5,
        OBSERVATION_POLARIZER = 6,
        MOSAIC_PLAIN = 0,
        MOSAIC_POLARIZED = 1,
        MOSAIC_POLARIZED_BAYER = 2,
        SENSOR_PRESET_IMX250MZR = 0,
        SENSOR_PRESET_IMX250MYR = 1,
        DEMOSAIC_BILINEAR = 0,
        DEMOSAIC_BLOCKS = 1,
        DEMOSAIC_GRADIENT = 2,
        HOST_SETS_STATE = 1,
        HOST_VALIDATE = 2,
        ENCODING_LINEAR = 0,
        ENCODING_SRGB = 1,
        DEPTH_MAPPING_PERSPECTIVE = 0,
        DEPTH_MAPPING_PERSPECTIVE_REVERSED = 1,
        DEPTH_MAPPING_ORTHOGRAPHIC = 2,
        DEPTH_MAPPING_ORTHOGRAPHIC_REVERSED = 3,
        PSH_MAX_ORDER = 4096,
        PSH_MAX_MATRIX_ORDER = 64,
        PSH_GRID_FEJER = 0,
        PSH_GRID_CLENSHAW_CURTIS = 1,
        PSH_GRID_GAUSS_LEGENDRE = 2,
        PSH_BAND_SIZE = 16,
        FILE_LIGHT_IMAGE = 1,
        FILE_LIGHT_CROSS = 2,
        FILE_LIGHT_PSH = 3,
        FILE_MATERIAL_PSH = 4,
        FILE_MATERIAL_MEASURED = 5,
        FILE_MATERIAL_TABLE = 6,
        FILE_BAND_LIMITED = 1,
        FILE_PHYSICAL = 2,
        FILE_ORDER_AUTOMATIC = 4294967295,
    },
    -- Functions that answer with a result code, and the handle that comes back through the last pointer.
    results = {
        device_count = true,
        device_get_info = true,
        context_create = "nicol_context",
        context_set_log = true,
        context_get_info = true,
        environment_load = "nicol_environment",
        environment_load_memory = "nicol_environment",
        environment_create_image = "nicol_environment",
        environment_create_constant = "nicol_environment",
        environment_create_sky = "nicol_environment",
        environment_create_psh = "nicol_environment",
        environment_get_info = true,
        texture_create_image = "nicol_texture",
        texture_load = "nicol_texture",
        texture_load_memory = "nicol_texture",
        texture_create_checkerboard = "nicol_texture",
        texture_create_vertex_colors = "nicol_texture",
        texture_create_face_colors = "nicol_texture",
        material_create_pplastic = "nicol_material",
        material_create_plastic = "nicol_material",
        material_create_principled = "nicol_material",
        material_create_diffuse = "nicol_material",
        material_create_conductor = "nicol_material",
        material_create_dielectric = "nicol_material",
        material_load_measured = "nicol_material",
        material_load_measured_memory = "nicol_material",
        material_load_psh = "nicol_material",
        material_load_psh_memory = "nicol_material",
        material_create_twosided = "nicol_material",
        material_create_scaled = "nicol_material",
        material_create_blend = "nicol_material",
        material_create_normal_map = "nicol_material",
        material_create_bump_map = "nicol_material",
        material_create_rotated = "nicol_material",
        material_create_mask = "nicol_material",
        material_create_callback = "nicol_material",
        mesh_load = "nicol_mesh",
        mesh_load_memory = "nicol_mesh",
        mesh_create = "nicol_mesh",
        mesh_create_sphere = "nicol_mesh",
        mesh_create_divided_sphere = "nicol_mesh",
        mesh_create_rectangle = "nicol_mesh",
        mesh_create_cube = "nicol_mesh",
        mesh_create_disk = "nicol_mesh",
        mesh_create_cylinder = "nicol_mesh",
        mesh_create_deformed = "nicol_mesh",
        mesh_get_size = true,
        mesh_get_bounds = true,
        camera_look_at = true,
        camera_set_opencv = true,
        camera_get_opencv = true,
        camera_frame = true,
        sky_get_sun = true,
        scene_create = "nicol_scene",
        scene_load = "nicol_scene",
        scene_set_time = true,
        scene_load_memory = "nicol_scene",
        scene_add_instance = true,
        scene_set_transform = true,
        scene_set_mesh = true,
        scene_set_material = true,
        scene_set_instance_flags = true,
        scene_get_instance_flags = true,
        scene_remove_instance = true,
        scene_get_instance = true,
        scene_get_bounds = true,
        scene_get_instance_count = true,
        scene_get_instance_ids = true,
        scene_set_environment = true,
        scene_get_environment = true,
        scene_hide_emitters = true,
        scene_add_light = true,
        scene_set_light = true,
        scene_remove_light = true,
        scene_get_light = "nicol_texture",
        scene_get_light_count = true,
        scene_get_light_ids = true,
        scene_set_emission = true,
        scene_get_emission = "nicol_texture",
        scene_add_polarization_element = true,
        scene_set_polarization_element = true,
        scene_remove_polarization_element = true,
        scene_get_polarization_element = true,
        scene_get_polarization_element_textures = "nicol_texture",
        scene_get_polarization_element_count = true,
        scene_get_polarization_element_ids = true,
        scene_get_camera = true,
        scene_get_film_size = true,
        scene_get_sample_count = true,
        scene_get_max_depth = true,
        scene_get_aovs = true,
        scene_get_file_count = true,
        scene_get_file = true,
        scene_get_channels = true,
        scene_get_filter = true,
        render_options_set_quality = true,
        framebuffer_create = "nicol_framebuffer",
        framebuffer_resize = true,
        framebuffer_get_size = true,
        framebuffer_blend = true,
        render = true,
        render_views = true,
        render_async = "nicol_job",
        job_poll = true,
        job_wait = true,
        job_cancel = true,
        framebuffer_get_statistics = true,
        framebuffer_read = true,
        framebuffer_read_plane = true,
        framebuffer_write_exr = true,
        framebuffer_encode_exr = true,
        framebuffer_write_png = true,
        framebuffer_encode_png = true,
        sensor_set_preset = true,
        sensor_load = true,
        sensor_load_memory = true,
        sensor_add_element = true,
        sensor_expose = true,
        framebuffer_expose = true,
        sensor_write_png = true,
        sensor_demosaic = true,
        render_adjoint = true,
        context_create_host = "nicol_context",
        framebuffer_create_textures = "nicol_framebuffer",
        framebuffer_get_texture = true,
        framebuffer_draw_plane = true,
        framebuffer_draw_stokes = true,
        framebuffer_draw_observation = true,
        psh_project_image = true,
        psh_project_environment = true,
        psh_project_file = true,
        psh_transform_create = "nicol_psh_transform",
        psh_transform_get_size = true,
        psh_transform_get_rows = true,
        psh_analyze = true,
        psh_synthesize = true,
        psh_evaluate = true,
        psh_rotate = true,
        psh_reflect = true,
        psh_multiply = true,
        psh_shadow_matrix = true,
        psh_project_matrix = true,
        psh_apply_matrix = true,
        psh_compose_matrix = true,
        psh_project_kernel = true,
        psh_kernel_at = true,
        psh_convolve = true,
        psh_kernel_matrix = true,
        psh_nearest_kernel = true,
        file_identify = true,
        file_describe_light = true,
        file_describe_material = true,
        file_convert = true,
        environment_write = true,
        material_write = true,
        file_demosaic = true,
        file_combine_angles = true,
        psh_write_file = true,
    },
    -- Descriptors: nicol_<name> with its nicol_<name>_init.
    structs = {
        spectrum = true,
        device_info = true,
        context_options = true,
        context_info = true,
        file_content = true,
        memory_file = true,
        image = true,
        sky = true,
        environment_load_options = true,
        environment_info = true,
        texture_image = true,
        texture_options = true,
        film = true,
        pplastic = true,
        plastic = true,
        principled = true,
        conductor = true,
        dielectric = true,
        measured = true,
        psh_matrix = true,
        callback_material = true,
        mesh_data = true,
        deformation = true,
        camera = true,
        polarization = true,
        light = true,
        emission = true,
        polarization_element = true,
        instance = true,
        scene_file = true,
        filter = true,
        render_options = true,
        job_status = true,
        statistics = true,
        plane_buffer = true,
        observation = true,
        sensor = true,
        stokes_image = true,
        raw_image = true,
        gradient = true,
        host = true,
        gl_texture = true,
        texture_target = true,
        psh_sampling = true,
        psh_mueller_field = true,
        file_options = true,
        light_report = true,
        material_report = true,
    },
}
