#include "apps/draw/picture.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <memory>
#include <new>
#include <stdexcept>
#include <string_view>

#include "history/compressor.h"
#include "history/descriptor.h"
#include "history/output_file.h"

namespace voroproof::internal {
namespace {

void check_cairo(cairo_status_t status) {
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  if (status != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error(std::string("cairo: ") + cairo_status_to_string(status));
}

cairo_status_t collect(void* bytes, const unsigned char* data, unsigned int size) {
  try {
    static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), size);
    return CAIRO_STATUS_SUCCESS;
  } catch (const std::bad_alloc&) {
    return CAIRO_STATUS_NO_MEMORY;
  }
}

struct SurfaceDeleter {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using Surface = std::unique_ptr<cairo_surface_t, SurfaceDeleter>;

using Paint = std::function<void(cairo_t*)>;

void paint_on(cairo_surface_t* surface, const Paint& paint) {
  check_cairo(cairo_surface_status(surface));
  struct Deleter {
    void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
  };
  const std::unique_ptr<cairo_t, Deleter> cairo(cairo_create(surface));
  paint(cairo.get());
  check_cairo(cairo_status(cairo.get()));
}

std::string png(const Paint& paint, int size) {
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, size, size));
  paint_on(surface.get(), paint);
  std::string bytes;
  check_cairo(cairo_surface_write_to_png_stream(surface.get(), collect, &bytes));
  return bytes;
}

// Cairo numbers the surfaces of a process and writes the number into the file:
// id="surface7". Nothing refers to it.
void remove_surface_number(std::string& svg) {
  constexpr std::string_view start = "<g id=\"surface";
  const std::size_t at = svg.find(start);
  if (at == std::string::npos) return;
  const std::size_t number = at + start.size();
  svg.erase(number, svg.find('"', number) - number);
}

std::string svg(const Paint& paint, int size) {
  std::string bytes;
  {
    const Surface surface(cairo_svg_surface_create_for_stream(collect, &bytes, size, size));
    cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
    paint_on(surface.get(), paint);
    cairo_surface_finish(surface.get());
    check_cairo(cairo_surface_status(surface.get()));
  }
  remove_surface_number(bytes);
  return bytes;
}

std::string pdf(const Paint& paint, int size) {
  constexpr double points = 0.75;  // in a pixel, 96 of which are an inch
  std::string bytes;
  const Surface surface(
      cairo_pdf_surface_create_for_stream(collect, &bytes, points * size, points * size));
  // Else it is the clock's.
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE,
                                 "2000-01-01T00:00:00Z");
  paint_on(surface.get(), [&](cairo_t* cairo) {
    cairo_scale(cairo, points, points);
    paint(cairo);
  });
  cairo_surface_finish(surface.get());
  check_cairo(cairo_surface_status(surface.get()));
  return bytes;
}

}  // namespace

bool names_picture(const std::string& path) {
  const std::string_view name = without_compression(path);
  return name.ends_with(".svg") || name.ends_with(".png") || name.ends_with(".pdf");
}

void write_picture(const std::string& path, int size, const std::function<void(cairo_t*)>& paint) {
  if (!names_picture(path) && !is_stream(path))
    throw std::invalid_argument("picture: the name must end in .svg, .png or .pdf");
  if (size < 16 || size > 20000)
    throw std::invalid_argument("picture: the size must lie between 16 and 20000 pixels");
  const std::string_view name = without_compression(path);
  const auto draw = name.ends_with(".png") ? png : name.ends_with(".pdf") ? pdf : svg;
  write_output(path, draw(paint, size));
}

}  // namespace voroproof::internal
