/* SPDX-License-Identifier: MIT */
/** @file foreign.c
 *  Names of SPlisHSPlasH, DualSPHysics, PySPH and OpenFOAM, of papers, and those that come to mind first. */
#include "files/foreign.h"

#include <string.h>

#include "files/tree.h"

/* A name may stand in several rows: the first holds, unless another row's key could stand where it was written. */
static const sph2d__foreign rows[] = {
    {"domain", "bounds,boundingbox,tank,size,geometry"},
    {"domain.max", "width,height,xmax,ymax,pointmax"},
    {"domain.min", "xmin,ymin,pointmin,origin"},
    {"boundary", "sides,boundaries,boundaryconditions,bc,periodic"},
    {"gravity", "g,gx,gy,gravitation"},
    {"spacing", "dx,dp,dr,ds,h,resolution,res,particlesize,particlespacing,particlediameter,gridsize,cellsize"},
    {"fluid", "liquid,fluids,liquids,material,materials,fluidmodel,fluidmodels"},
    {"fluid.density", "rho,rho0,ro,rhop0,density0,restdensity,referencedensity"},
    {"fluid.dynamic_viscosity", "viscosity,mu,eta,visco"},
    {"fluid.surface_tension", "sigma,tension"},
    {"method", "solver,scheme,integrator,simulationmethod,pressuresolver,formulation"},
    {"method.time_step", "dt,deltat,timestepsize,dtini,step"},
    {"method.cfl", "cflnumber,cflfactor,courant,maxco"},
    {"method.sound_speed", "c,c0,cs,co,speedsound,speedofsound"},
    {"method.support_ratio", "hdx,coefh,hfactor,kernelradius,supportradius"},
    {"method.artificial_viscosity", "alpha"},
    {"method.density_diffusion", "deltasph,densitydt,densitydtvalue"},
    {"method.max_compression", "maxerror,compressibility"},
    {"blocks", "block,fluidblocks,water,drops,initial,fillbox"},
    {"blocks[0].box", "size,rectangle,rect,cube"},
    {"blocks[0].circle", "r,sphere"},
    {"blocks[0].circle.center", "position,pos"},
    {"probes[0].at", "position,pos,location,point,place"},
    {"blocks[0].circle.radius", "r,r0"},
    {"blocks[0].velocity", "v,v0,vel,initialvelocity"},
    {"sources", "emitters,emitter,nozzles,nozzle,jet"},
    {"drains", "sinks,sink"},
    {"openings", "inlet,inlets,inflow,outflow,outlet,outlets,inout"},
    {"obstacles", "solids,solid,boundarymodels,staticbodies"},
    {"bodies", "rigidbodies,rigidbody,rigid,floatings,floating,objects"},
    {"probes", "sensors,sensor,gauges,measurements,measure,measuretool,diagnostics"},
    {"run.until", "time,t,duration,end,tend,tf,tmax,timemax,endtime,maxtime,stop,stopat,stoptime,finaltime,totaltime,"
                  "tfinal,simulationtime,runtime"},
    {"run.snapshots", "output,outputs,save,vtk,writer,dump,export"},
    {"run.snapshots.every", "timeout,writeinterval,outputinterval,saveinterval,interval,dt,period,pfreq"},
    {"run.snapshots.per_second", "dataexportfps,frequency,rate"},
    {"run.frames", "images,pictures,video,film,movie,animation,render"},
    {"run.frames.per_second", "fps,framerate"},
    {"run.frames.size", "resolution,width,height"},
    {"domain.max", "end,upper"},
    {"domain.min", "start,lower"},
};

const sph2d__foreign *sph2d__foreign_row(size_t i)
{
    return i < sizeof rows / sizeof *rows ? &rows[i] : NULL;
}

/** The key of that name among some; NULL if there is none. */
static const sph2d_key *find(const sph2d_keys *keys, const char *name, size_t length)
{
    for (size_t i = 0; keys && i < keys->count; ++i)
        if (strlen(keys->items[i].name) == length && memcmp(keys->items[i].name, name, length) == 0)
            return &keys->items[i];
    return NULL;
}

const sph2d_key *sph2d__foreign_key(const char *path)
{
    const sph2d_keys *keys = sph2d_scene_keys();
    const sph2d_key *key = NULL;
    for (sph2d__step step; *path && sph2d__path_step(&path, &step);) {
        if (step.name && !(key = find(keys, step.name, step.length)))
            return NULL;
        keys = key ? key->keys : NULL;
    }
    return *path ? NULL : key;
}

/** Whether one of the names is `name`, in any case and with _ or - in it. */
static bool has(const char *names, const char *name)
{
    while (*names) {
        const char *c = name;
        for (; *c && (*c == '_' || *c == '-' || *names == (*c >= 'A' && *c <= 'Z' ? *c | 0x20 : *c)); ++c)
            names += *c != '_' && *c != '-';
        if (!*c && (*names == ',' || !*names))
            return true;
        names += strcspn(names, ",");
        names += *names == ',';
    }
    return false;
}

const char *sph2d__foreign_path(const char *name, const sph2d_keys *here, const sph2d_key **key)
{
    const char *first = NULL;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; ++i) {
        if (!has(rows[i].names, name))
            continue;
        const char *last = strrchr(rows[i].path, '.');
        last = last ? last + 1 : rows[i].path;
        if ((*key = find(here, last, strlen(last))))
            return last;
        if (!first)
            first = rows[i].path;
    }
    *key = first ? sph2d__foreign_key(first) : NULL;
    return *key ? first : NULL;
}
