// CGAL's alpha shapes behind a pipe, over exact rationals: an opponent for the tests of alpha values; and, over doubles, a clock.
//
// In: requests, one after the other, until the end of input.
//   alpha2 N     then N lines  x y          alpha3 N     then N lines  x y z
//   walpha2 N    then N lines  x y w        walpha3 N    then N lines  x y z w   (w is the weight)
//   time2 N, time3 N: as alpha2 and alpha3, with inexact constructions; the answer has no lines
// Coordinates are the 16 hexadecimal digits of the double's bits. All points must not lie in a plane, or line.
// Out: ok D K SECONDS, then K lines: the number of ids, the ids, and the value as a reduced fraction. In the plane there are edges and
// triangles; in space all simplices. Or: refused MESSAGE.

#include <chrono>
#include <cstdint>
#include <cstring>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include <CGAL/Alpha_shape_2.h>
#include <CGAL/Alpha_shape_3.h>
#include <CGAL/Alpha_shape_cell_base_3.h>
#include <CGAL/Alpha_shape_face_base_2.h>
#include <CGAL/Alpha_shape_vertex_base_2.h>
#include <CGAL/Alpha_shape_vertex_base_3.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/iterator.h>

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Id = std::uint32_t;

template <class K>
using Shape2 = CGAL::Alpha_shape_2<CGAL::Delaunay_triangulation_2<
    K, CGAL::Triangulation_data_structure_2<
           CGAL::Alpha_shape_vertex_base_2<K, CGAL::Triangulation_vertex_base_with_info_2<Id, K>>,
           CGAL::Alpha_shape_face_base_2<K>>>>;
template <class K>
using Shape3 = CGAL::Alpha_shape_3<CGAL::Delaunay_triangulation_3<
    K, CGAL::Triangulation_data_structure_3<
           CGAL::Alpha_shape_vertex_base_3<K, CGAL::Triangulation_vertex_base_with_info_3<Id, K>>,
           CGAL::Alpha_shape_cell_base_3<K, CGAL::Delaunay_triangulation_cell_base_3<K>>>>>;
using Weighted2 = CGAL::Alpha_shape_2<CGAL::Regular_triangulation_2<
    Exact, CGAL::Triangulation_data_structure_2<
               CGAL::Alpha_shape_vertex_base_2<
                   Exact, CGAL::Triangulation_vertex_base_with_info_2<
                              Id, Exact, CGAL::Regular_triangulation_vertex_base_2<Exact>>>,
               CGAL::Alpha_shape_face_base_2<Exact, CGAL::Regular_triangulation_face_base_2<Exact>>>>>;
using Weighted3 = CGAL::Alpha_shape_3<CGAL::Regular_triangulation_3<
    Exact, CGAL::Triangulation_data_structure_3<
               CGAL::Alpha_shape_vertex_base_3<
                   Exact, CGAL::Triangulation_vertex_base_with_info_3<
                              Id, Exact, CGAL::Regular_triangulation_vertex_base_3<Exact>>>,
               CGAL::Alpha_shape_cell_base_3<Exact, CGAL::Regular_triangulation_cell_base_3<Exact>>>>>;

namespace {

double read_double() {
  std::string digits;
  std::cin >> digits;
  const std::uint64_t bits = std::stoull(digits, nullptr, 16);
  double value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

struct Clock {
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
};

template <class P> P point() ;
template <> Exact::Point_2 point() { const double x = read_double(), y = read_double(); return {x, y}; }
template <> Inexact::Point_2 point() { const double x = read_double(), y = read_double(); return {x, y}; }
template <> Exact::Point_3 point() { const double x = read_double(), y = read_double(), z = read_double(); return {x, y, z}; }
template <> Inexact::Point_3 point() { const double x = read_double(), y = read_double(), z = read_double(); return {x, y, z}; }
template <> Exact::Weighted_point_2 point() { const auto p = point<Exact::Point_2>(); return {p, read_double()}; }
template <> Exact::Weighted_point_3 point() { const auto p = point<Exact::Point_3>(); return {p, read_double()}; }

template <class P>
std::vector<std::pair<P, Id>> read_points() {
  std::size_t n;
  std::cin >> n;
  std::vector<std::pair<P, Id>> points;
  for (Id i = 0; i < n; ++i) points.emplace_back(point<P>(), i);
  return points;
}

struct Lines {
  std::ostringstream text;
  std::size_t count = 0;
  template <class Ids, class FT>
  void add(const Ids& ids, const FT& value) {
    text << ids.size();
    for (const Id id : ids) text << ' ' << id;
    text << ' ' << CGAL::exact(value) << '\n';
    ++count;
  }
};

void answer(int dimension, const Lines& lines, double seconds) {
  std::cout << "ok " << dimension << ' ' << lines.count << ' ' << seconds << '\n' << lines.text.str() << std::flush;
}

template <class Shape, class P>
void plane() {
  const auto points = read_points<P>();
  const Clock clock;
  typename Shape::Triangulation t(points.begin(), points.end());
  Shape shape(t, 0, Shape::GENERAL);
  const double seconds = clock.seconds();
  Lines lines;
  for (const auto f : shape.finite_face_handles())
    lines.add(std::vector<Id>{f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()}, f->get_alpha());
  for (const auto& e : shape.finite_edges()) {
    const auto ranges = e.first->get_ranges(e.second);
    const bool attached = ranges.first == -2;  // so CGAL marks it, whatever the weights: ask for no value of -2
    lines.add(std::vector<Id>{e.first->vertex(shape.cw(e.second))->info(), e.first->vertex(shape.ccw(e.second))->info()},
              attached ? ranges.second : ranges.first);
  }
  answer(2, lines, seconds);
}

template <class Shape, class P>
void space() {
  const auto points = read_points<P>();
  const Clock clock;
  typename Shape::Triangulation t(points.begin(), points.end());
  Shape shape(t, 0, Shape::GENERAL);
  const double seconds = clock.seconds();
  std::vector<CGAL::Object> objects;
  std::vector<typename Shape::FT> values;
  using Out = CGAL::Dispatch_output_iterator<
      std::tuple<CGAL::Object, typename Shape::FT>,
      std::tuple<std::back_insert_iterator<std::vector<CGAL::Object>>, std::back_insert_iterator<std::vector<typename Shape::FT>>>>;
  shape.filtration_with_alpha_values(Out(std::back_inserter(objects), std::back_inserter(values)));
  Lines lines;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    std::vector<Id> ids;
    typename Shape::Cell_handle c;
    typename Shape::Facet f;
    typename Shape::Edge e;
    typename Shape::Vertex_handle v;
    if (CGAL::assign(c, objects[i]))
      for (int j = 0; j < 4; ++j) ids.push_back(c->vertex(j)->info());
    else if (CGAL::assign(f, objects[i])) {
      for (int j = 0; j < 4; ++j) if (j != f.second) ids.push_back(f.first->vertex(j)->info());
    } else if (CGAL::assign(e, objects[i]))
      ids = {e.first->vertex(e.second)->info(), e.first->vertex(e.third)->info()};
    else if (CGAL::assign(v, objects[i])) ids = {v->info()};
    lines.add(ids, values[i]);
  }
  answer(3, lines, seconds);
}

template <class Shape, class P>
void timed(int dimension) {
  const auto points = read_points<P>();
  const Clock clock;
  typename Shape::Triangulation t(points.begin(), points.end());
  Shape shape(t, 0, Shape::GENERAL);
  answer(dimension, Lines(), clock.seconds());
}

}  // namespace

int main() {
  std::ios::sync_with_stdio(false);
  std::string request;
  while (std::cin >> request) {
    try {
      if (request == "alpha2") plane<Shape2<Exact>, Exact::Point_2>();
      else if (request == "alpha3") space<Shape3<Exact>, Exact::Point_3>();
      else if (request == "walpha2") plane<Weighted2, Exact::Weighted_point_2>();
      else if (request == "walpha3") space<Weighted3, Exact::Weighted_point_3>();
      else if (request == "time2") timed<Shape2<Inexact>, Inexact::Point_2>(2);
      else if (request == "time3") timed<Shape3<Inexact>, Inexact::Point_3>(3);
      else std::cout << "refused unknown request " << request << std::endl;
    } catch (const std::exception& e) {
      std::string message = e.what();
      for (char& c : message) if (c == '\n') c = ' ';
      std::cout << "refused " << message << std::endl;
    }
  }
}
