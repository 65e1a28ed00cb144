// CGAL behind a pipe: an opponent for the differential tests and the benchmarks.
//
// In: requests, one after the other, until the end of input.
//   delaunay2 N      then N lines  x y        delaunay3 N   then N lines  x y z
//   regular2 N       then N lines  x y w      regular3 N    then N lines  x y z w   (w is the weight)
//   cdt N M          then N lines  x y, then M lines  i j
//   conform delaunay|gabriel N M     the same lines; Steiner points are added
//   refine DEGREES SIZE N M          the same lines; DEGREES is the least angle asked for, SIZE the longest edge, 0 for any
// Coordinates are the 16 hexadecimal digits of the double's bits, so that nothing is rounded on the way.
// Out, for each request:
//   ok DIMENSION K SECONDS    then K lines of DIMENSION + 1 ids, the finite cells; hidden points are in none
//   counted VERTICES CELLS SECONDS    for conform and refine; the cells are those of the domain. After ten seconds, or DELONE_PATIENCE, the program ends
//   refused MESSAGE           CGAL threw, for instance because constraints intersect
// The construction alone is timed.

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Triangulation_cell_base_3.h>
#include <CGAL/Triangulation_conformer_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Id = std::uint32_t;

using Vertex2 = CGAL::Triangulation_vertex_base_with_info_2<Id, Kernel>;
using Structure2 = CGAL::Triangulation_data_structure_2<Vertex2>;
using Delaunay2 = CGAL::Delaunay_triangulation_2<Kernel, Structure2>;

using ConstrainedStructure =
    CGAL::Triangulation_data_structure_2<Vertex2, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Constrained = CGAL::Constrained_Delaunay_triangulation_2<Kernel, ConstrainedStructure,
                                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;

using Meshed = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel,
    CGAL::Triangulation_data_structure_2<CGAL::Delaunay_mesh_vertex_base_2<Kernel>,
                                         CGAL::Delaunay_mesh_face_base_2<Kernel>>,
    CGAL::No_constraint_intersection_requiring_constructions_tag>;

using Vertex3 = CGAL::Triangulation_vertex_base_with_info_3<Id, Kernel>;
using Structure3 =
    CGAL::Triangulation_data_structure_3<Vertex3, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using Delaunay3 = CGAL::Delaunay_triangulation_3<Kernel, Structure3>;

using RegularVertex2 =
    CGAL::Triangulation_vertex_base_with_info_2<Id, Kernel, CGAL::Regular_triangulation_vertex_base_2<Kernel>>;
using Regular2 = CGAL::Regular_triangulation_2<
    Kernel,
    CGAL::Triangulation_data_structure_2<RegularVertex2, CGAL::Regular_triangulation_face_base_2<Kernel>>>;

using RegularVertex3 =
    CGAL::Triangulation_vertex_base_with_info_3<Id, Kernel, CGAL::Regular_triangulation_vertex_base_3<Kernel>>;
using Regular3 = CGAL::Regular_triangulation_3<
    Kernel,
    CGAL::Triangulation_data_structure_3<RegularVertex3, CGAL::Regular_triangulation_cell_base_3<Kernel>>>;

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

using Cells = std::vector<Id>;

void answer(int dimension, const Cells& cells, double seconds) {
  const std::size_t count = dimension < 0 ? 0 : cells.size() / (dimension + 1);
  std::cout << "ok " << dimension << ' ' << count << ' ' << seconds << '\n';
  for (std::size_t i = 0; i < cells.size(); ++i) {
    std::cout << cells[i] << ((i + 1) % (dimension + 1) == 0 ? '\n' : ' ');
  }
  std::cout.flush();
}

template <class Triangulation>
Cells cells_of_2(const Triangulation& t) {
  Cells cells;
  if (t.dimension() == 2) {
    for (const auto f : t.finite_face_handles())
      for (int i = 0; i < 3; ++i) cells.push_back(f->vertex(i)->info());
  } else if (t.dimension() == 1) {
    for (const auto& e : t.finite_edges()) {
      cells.push_back(e.first->vertex(t.cw(e.second))->info());
      cells.push_back(e.first->vertex(t.ccw(e.second))->info());
    }
  } else if (t.dimension() == 0) {
    cells.push_back(t.finite_vertices_begin()->info());
  }
  return cells;
}

template <class Triangulation>
Cells cells_of_3(const Triangulation& t) {
  Cells cells;
  if (t.dimension() == 3) {
    for (const auto c : t.finite_cell_handles())
      for (int i = 0; i < 4; ++i) cells.push_back(c->vertex(i)->info());
  } else if (t.dimension() == 2) {
    for (const auto& f : t.finite_facets())
      for (int i = 0; i < 3; ++i) cells.push_back(f.first->vertex(i)->info());
  } else if (t.dimension() == 1) {
    for (const auto& e : t.finite_edges()) {
      cells.push_back(e.first->vertex(e.second)->info());
      cells.push_back(e.first->vertex(e.third)->info());
    }
  } else if (t.dimension() == 0) {
    cells.push_back(t.finite_vertices_begin()->info());
  }
  return cells;
}

std::vector<std::pair<Kernel::Point_2, Id>> read_points_2(std::size_t n) {
  std::vector<std::pair<Kernel::Point_2, Id>> points;
  points.reserve(n);
  for (Id i = 0; i < n; ++i) {
    const double x = read_double();
    const double y = read_double();
    points.emplace_back(Kernel::Point_2(x, y), i);
  }
  return points;
}

void delaunay2() {
  std::size_t n;
  std::cin >> n;
  const auto points = read_points_2(n);
  const Clock clock;
  const Delaunay2 t(points.begin(), points.end());
  const double seconds = clock.seconds();
  answer(t.dimension(), cells_of_2(t), seconds);
}

void delaunay3() {
  std::size_t n;
  std::cin >> n;
  std::vector<std::pair<Kernel::Point_3, Id>> points;
  points.reserve(n);
  for (Id i = 0; i < n; ++i) {
    const double x = read_double();
    const double y = read_double();
    const double z = read_double();
    points.emplace_back(Kernel::Point_3(x, y, z), i);
  }
  const Clock clock;
  const Delaunay3 t(points.begin(), points.end());
  const double seconds = clock.seconds();
  answer(t.dimension(), cells_of_3(t), seconds);
}

void regular2() {
  std::size_t n;
  std::cin >> n;
  std::vector<std::pair<Kernel::Weighted_point_2, Id>> points;
  points.reserve(n);
  for (Id i = 0; i < n; ++i) {
    const double x = read_double();
    const double y = read_double();
    const double w = read_double();
    points.emplace_back(Kernel::Weighted_point_2(Kernel::Point_2(x, y), w), i);
  }
  const Clock clock;
  const Regular2 t(points.begin(), points.end());
  const double seconds = clock.seconds();
  answer(t.dimension(), cells_of_2(t), seconds);
}

void regular3() {
  std::size_t n;
  std::cin >> n;
  std::vector<std::pair<Kernel::Weighted_point_3, Id>> points;
  points.reserve(n);
  for (Id i = 0; i < n; ++i) {
    const double x = read_double();
    const double y = read_double();
    const double z = read_double();
    const double w = read_double();
    points.emplace_back(Kernel::Weighted_point_3(Kernel::Point_3(x, y, z), w), i);
  }
  const Clock clock;
  const Regular3 t(points.begin(), points.end());
  const double seconds = clock.seconds();
  answer(t.dimension(), cells_of_3(t), seconds);
}

void cdt() {
  std::size_t n, m;
  std::cin >> n >> m;
  const auto points = read_points_2(n);
  std::vector<std::pair<Id, Id>> segments(m);
  for (auto& s : segments) std::cin >> s.first >> s.second;
  const Clock clock;
  Constrained t;
  t.insert(points.begin(), points.end());
  std::vector<Constrained::Vertex_handle> vertices(n);
  for (auto v : t.finite_vertex_handles()) vertices[v->info()] = v;
  for (const auto& s : segments) t.insert_constraint(vertices[s.first], vertices[s.second]);
  const double seconds = clock.seconds();
  answer(t.dimension(), cells_of_2(t), seconds);
}

std::vector<std::pair<Id, Id>> read_segments(std::size_t m) {
  std::vector<std::pair<Id, Id>> segments(m);
  for (auto& s : segments) std::cin >> s.first >> s.second;
  return segments;
}

template <class Triangulation>
void insert_all(Triangulation& t, const std::vector<std::pair<Kernel::Point_2, Id>>& points,
                const std::vector<std::pair<Id, Id>>& segments) {
  std::vector<Kernel::Point_2> places;
  for (const auto& p : points) places.push_back(p.first);
  t.insert_constraints(places.begin(), places.end(), segments.begin(), segments.end());
}

unsigned patience() {
  const char* seconds = std::getenv("DELONE_PATIENCE");
  return seconds ? std::stoul(seconds) : 10;
}

void counted(std::size_t vertices, std::size_t cells, double seconds) {
  alarm(0);
  std::cout << "counted " << vertices << ' ' << cells << ' ' << seconds << std::endl;
}

void conform() {
  std::string strength;
  std::size_t n, m;
  std::cin >> strength >> n >> m;
  const auto points = read_points_2(n);
  const auto segments = read_segments(m);
  alarm(patience());
  const Clock clock;
  Constrained t;
  insert_all(t, points, segments);
  if (strength == "gabriel") CGAL::make_conforming_Gabriel_2(t);
  else CGAL::make_conforming_Delaunay_2(t);
  counted(t.number_of_vertices(), t.number_of_faces(), clock.seconds());
}

void refine() {
  double degrees, size;
  std::size_t n, m;
  std::cin >> degrees >> size >> n >> m;
  const auto points = read_points_2(n);
  const auto segments = read_segments(m);
  const double sine = std::sin(degrees * 3.14159265358979323846 / 180);
  alarm(patience());
  const Clock clock;
  Meshed t;
  insert_all(t, points, segments);
  CGAL::refine_Delaunay_mesh_2(t, CGAL::Delaunay_mesh_size_criteria_2<Meshed>(sine * sine, size));
  const double seconds = clock.seconds();
  std::size_t cells = 0;
  for (const auto f : t.finite_face_handles()) cells += f->is_in_domain();
  counted(t.number_of_vertices(), cells, seconds);
}

}  // namespace

int main() {
  std::ios::sync_with_stdio(false);
  std::string request;
  while (std::cin >> request) {
    try {
      if (request == "delaunay2") delaunay2();
      else if (request == "delaunay3") delaunay3();
      else if (request == "regular2") regular2();
      else if (request == "regular3") regular3();
      else if (request == "cdt") cdt();
      else if (request == "conform") conform();
      else if (request == "refine") refine();
      else std::cout << "refused unknown request " << request << std::endl;
    } catch (const std::exception& e) {
      std::string message = e.what();
      for (char& c : message) if (c == '\n') c = ' ';
      std::cout << "refused " << message << std::endl;
    }
  }
}
