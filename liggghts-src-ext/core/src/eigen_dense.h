// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_EIGEN_DENSE_H
#define RODPACK_EIGEN_DENSE_H

// Eigen's dense matrices and eigenvalues, wherever its headers are: in the compiler's path, or in
// its own folder of /usr/include, so that a LIGGGHTS tree of one's own needs no further -I. For
// sources only, not for public headers.
//
// On a machine that has AVX-512, GCC 12 warns of its own header of it, seen through Eigen.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#ifdef __has_include
#if __has_include(<Eigen/Dense>)
#include <Eigen/Dense>
#elif __has_include(<eigen3/Eigen/Dense>)
#include <eigen3/Eigen/Dense>
#else
#error "Eigen's headers were not found: install libeigen3-dev, or add -I <folder of Eigen/>"
#endif
#else
#include <Eigen/Dense>
#endif
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

#endif
