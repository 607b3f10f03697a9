/* SPDX-License-Identifier: MIT */
/** @file parts.c
 *  A call of each library that it is linked with, which take each other's types. */
#include <stdio.h>
#include <string.h>

#include <sph2d/contacts.h>
#include <sph2d/io.h>
#include <sph2d/study_results.h>
#ifdef WITH_render
#include <sph2d/render.h>
#endif

int main(void)
{
    if (strcmp(sph2d_version(), SPH2D_VERSION) != 0 || sph2d_contacts_attach(NULL) == SPH2D_OK)
        return 1;
    sph2d_study_record_free(NULL);
#ifdef WITH_render
    sph2d_renderer_destroy(NULL);
#endif
    return puts(sph2d_io_hdf5_version()) < 0;
}
